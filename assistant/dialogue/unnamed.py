"""A step that was shown but never introduced: it gets a name, or belongs to another."""

from __future__ import annotations

from dataclasses import replace

from assistant.dialogue.asking import index_of, learn, tell
from assistant.dialogue.introduction import with_roles
from assistant.dialogue.naming import alike
from assistant.dialogue.sketch import Sketch, inserted, names
from assistant.dialogue.state import Dialogue, Reviewing
from assistant.dialogue.turn import Turn, changed, first, line, say
from assistant.language.actions import read_action
from assistant.learning.apart import set_apart
from assistant.model.lesson import Episode
from assistant.model.task import Action


def names_new_step(state: Reviewing) -> bool:
    """Whether the open question asks for the name of a step that was never introduced."""
    return bool(state.questions) and state.questions[0].reason == "never_introduced"


def introduced_late(dialogue: Dialogue, name: str, from_s: float, to_s: float) -> Turn:
    """Take the name of a step that was shown but not introduced, and learn with it."""
    known, lesson = dialogue.known, dialogue.known.lesson
    if lesson is None or alike(name, names(known.root)):
        return tell(dialogue, line("error", "name_taken", name=name))
    cuts_s, taken = set_apart(lesson.segmentation.episodes, name, from_s, to_s)
    number = taken.index(name) if name in taken else 0
    after = index_of(known, taken[number - 1]) if number else ()
    parent, position = (after[:-1], after[-1] + 1) if after else ((), 1)
    # It was seen as one motion; without a word for it, it is done as shown.
    action = read_action(name, known.objects or (), known.language).action or Action("free", name)
    root = inserted(known.root, parent, position, Sketch(name, True, action=action))
    assigned = tuple((part, told) for part, told in enumerate(taken, start=1) if told)
    more = replace(known, root=root, cuts_s=cuts_s, assigned=assigned)
    added = changed(dialogue, "added", with_roles(more))
    return first(say(added, line("done", "added", name=name))[1], learn(added))


def no_step_of_its_own(dialogue: Dialogue, state: Reviewing) -> Turn | None:
    """Join what was taken for a step of its own to the step that it leads to, and learn so.

    None where it is a piece of a step that was introduced, and all stays as it was learned.
    """
    lesson, facts = dialogue.known.lesson, state.questions[0].facts
    episodes = lesson.segmentation.episodes if lesson is not None else ()
    from_s, to_s = (float(str(facts.get(key, 0.0))) for key in ("from_s", "to_s"))
    alone = [
        n for n, one in enumerate(episodes) if not one.primitive and _within(one, from_s, to_s)
    ]
    if not alone:
        return None
    names: list[str] = [one.primitive or "" for one in episodes]
    for n in reversed(alone):
        names[n] = next((name for name in names[n + 1 :] if name), "")
        names[n] = names[n] or next((name for name in reversed(names[:n]) if name), "")
    # What has joined another step is no part of its own any more.
    joined = {
        n for one in alone for n in (one - 1, one) if names[n : n + 1] == names[n + 1 : n + 2]
    }
    ends = [n for n in range(len(names) - 1) if n not in joined]
    firsts = [0, *(n + 1 for n in ends)]
    cuts_s = tuple(episodes[n].to_s for n in ends)
    assigned = tuple((part, names[n]) for part, n in enumerate(firsts, start=1) if names[n])
    known = replace(dialogue.known, cuts_s=cuts_s, assigned=assigned)
    return learn(changed(dialogue, "assigned", known))


def _within(episode: Episode, from_s: float, to_s: float) -> bool:
    return from_s <= (episode.from_s + episode.to_s) / 2.0 <= to_s
