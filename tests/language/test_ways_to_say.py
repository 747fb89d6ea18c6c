from assistant.language.phrasebook import phrasebook
from assistant.language.templates import matches
from assistant.language.ways_to_say import Sentence

LINES = ("go on", "keep going please", "call it lift", "a bit more left", "what did you say")


def ways(text: str) -> list[Sentence]:
    texts = tuple(text.split())
    return [one for one in phrasebook().sentences if any(True for _ in matches(one.nodes, texts))]


def test_what_may_match_by_a_quick_look_holds_all_that_matches() -> None:
    for line in LINES:
        texts = tuple(line.split())
        quick = set(map(id, phrasebook().candidates(texts)))
        assert all(id(one) in quick for one in ways(line))
    assert any(ways(line) for line in LINES)
