"""The spoken shell: ears, recognizers, a spotter for stop, and a mouth; an extra of its own.

Nothing is downloaded at run time: models come inside installed packages or from a folder the
teacher names.
"""
