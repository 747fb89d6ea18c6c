"""plain_yaml."""
