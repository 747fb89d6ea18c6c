"""What was not heard surely: the best guess is read back and asked about, never acted on.

A teacher who is not understood twice hears what can be said, and where an answer may be any
words, is asked whether the words were the answer: no question of the introduction is a dead end.
"""

from __future__ import annotations

from dataclasses import replace

from assistant.dialogue.asking import ask, question, tell
from assistant.dialogue.finding import candidates
from assistant.dialogue.helping import help_line
from assistant.dialogue.naming import as_said, begins_or_ends_with_verb, is_odd, steps_in, tidy
from assistant.dialogue.placing import thing_meant
from assistant.dialogue.sketch import names
from assistant.dialogue.spots import SPOT, offered
from assistant.dialogue.state import Dialogue, Introducing, Pending, Watching
from assistant.dialogue.things import things_in, without_relative
from assistant.dialogue.turn import Turn, Words, first, line, say
from assistant.language.hints import hints, mentions
from assistant.model import teacher_acts as acts
from assistant.model.teacher_acts import act_to_json

MOST_GUESSES = 2
"""Guesses read back one after the other before the robot tells what can be said."""
TOPIC = "did_you_mean"
GUESSES = (TOPIC, "take_words", "listed_steps", "place_shown", SPOT, "stands_elsewhere")
"""Questions whether the robot's guess is what was meant; who says something else answers it."""
IN_ANY_WORDS = ("task_name", "goal", "objects", "subtask_name", "actions")
"""Questions whose answer may be any words."""
_ONE_STEP = (acts.RemoveSubtask, acts.Split, acts.Optional, acts.Required)
_NO_PLACE = (
    acts.Unknown,
    acts.Inform,
    acts.Affirm,
    acts.Deny,
    acts.Start,
    acts.Show,
    acts.GoBack,
    acts.Translate,
)
FEWEST_STEPS, LONGEST_STEP, LONGEST_ANSWER, LONGEST_THING = 3, 8, 12, 3


def is_guess(pending: Pending | None) -> bool:
    """Whether the question in between is a guess that was read back."""
    return pending is not None and pending.line.topic.split(".")[0] in GUESSES


def without_guess(dialogue: Dialogue) -> Dialogue:
    """Return the dialogue as it was before a guess was read back."""
    pending = dialogue.pending
    guessed = pending is not None and is_guess(pending)
    return replace(dialogue, pending=pending.over) if pending and guessed else dialogue


def doubted(
    dialogue: Dialogue,
    meant: tuple[acts.TeacherAct, ...],
    words: Words,
    other: tuple[acts.TeacherAct, ...] = (),
) -> Turn:
    """Read back the best guess and ask; never act on it.

    `other` is what is meant if not that, where it is known already.
    """
    if isinstance(dialogue.state, Watching) and not _ends(meant):
        return dialogue, ()
    if not words.by_voice and all(isinstance(act, acts.Help) for act in meant):
        # To help does no harm where it was typed; what was misheard was an answer, and is lost.
        return tell(without_guess(dialogue), help_line(without_guess(dialogue)))
    meant = tuple(_of_what_was_asked(dialogue, act) for act in meant)
    instead = (
        _steps_listed(dialogue, words)
        or _place_shown(dialogue, meant)
        or _no_such_step(dialogue, meant)
        or _things_told(dialogue, meant, words)
    )
    if instead is not None:
        return instead
    if any(_moves_nothing(dialogue, act) for act in meant):
        return misunderstood(dialogue, words)
    if _says_yes_or_no(meant) and dialogue.pending is not None:
        return _yes_or_no(dialogue)
    state = dialogue.state
    if isinstance(state, Introducing) and state.asked != "confirm_tree" and _says_yes_or_no(meant):
        missed = replace(dialogue, misses=dialogue.misses + 1)
        return tell(missed, line("error", "not_an_answer"))
    asks = _says_yes_or_no(meant) and _asks(dialogue, words.text)
    if all(isinstance(act, acts.Unknown) for act in meant) or asks or not _fresh(dialogue, meant):
        return misunderstood(dialogue, words)
    # A no before what is wanted instead is no part of it: "no, more down".
    meant = tuple(act for act in meant if not isinstance(act, acts.Affirm | acts.Deny)) or meant
    told = [_told(act, words.text) for act in meant]
    guess = line("confirm", _topic(dialogue, meant), asked="did_you_mean", acts=told)
    over = without_guess(dialogue).pending
    pending = Pending("did_you_mean", guess, meant, words.text, other=other, over=over)
    return _asked_between(dialogue, pending)


def _moves_nothing(dialogue: Dialogue, act: acts.TeacherAct) -> bool:
    """Whether a place is told and not what stands there, nor is that asked."""
    asked = isinstance(dialogue.state, Introducing) and dialogue.state.thing
    return isinstance(act, acts.SetPose) and not act.object and not asked


def misunderstood(dialogue: Dialogue, words: Words) -> Turn:
    """Tell that nothing was understood; the second time also what can be said now."""
    if isinstance(dialogue.state, Watching):
        return dialogue, ()
    missed = replace(without_guess(dialogue), misses=dialogue.misses + 1)
    if dialogue.misses == 0:
        return tell(missed, line("error", "not_understood"))
    # Whoever was helped begins anew: what is said next may be guessed again.
    helped = replace(missed, misses=0)
    lines = (line("error", "not_understood_again"), help_line(helped))
    taken = _taking_words(helped, words)
    return tell(helped, *lines) if taken is None else first(say(helped, *lines)[1], taken)


def _fresh(dialogue: Dialogue, meant: tuple[acts.TeacherAct, ...]) -> bool:
    """Whether a guess may be read back: one that was not just passed over, and not ever more."""
    pending = dialogue.pending
    passed_over = pending is not None and is_guess(pending) and pending.acts == meant
    return dialogue.misses < MOST_GUESSES and not passed_over


def _ends(meant: tuple[acts.TeacherAct, ...]) -> bool:
    return any(isinstance(act, acts.Approve | acts.Affirm) for act in meant)


def _no_such_step(dialogue: Dialogue, meant: tuple[acts.TeacherAct, ...]) -> Turn | None:
    """Tell that no step is called what one change of the plan refers to."""
    only, there = (meant[0] if len(meant) == 1 else None), names(dialogue.known.root)
    if not isinstance(only, _ONE_STEP) or not there or candidates(dialogue.known, only.subtask):
        return None
    told = line("error", "no_such_step", name=only.subtask, names=list(there))
    return tell(replace(dialogue, misses=dialogue.misses + 1), told)


def _says_yes_or_no(meant: tuple[acts.TeacherAct, ...]) -> bool:
    return all(isinstance(act, acts.Affirm | acts.Deny) for act in meant)


def _asks(dialogue: Dialogue, text: str) -> bool:
    """Whether a text asks something, so that it is neither a yes nor a no."""
    words = text.lower().split()
    first_word = words[0] if words else ""
    return text.rstrip().endswith("?") or first_word in hints("question_words", dialogue.language)


def _yes_or_no(dialogue: Dialogue) -> Turn:
    """Ask for a plain yes or no: "did you mean yes?" would only add a question."""
    return tell(replace(dialogue, misses=dialogue.misses + 1), line("told", "yes_or_no"))


def _topic(dialogue: Dialogue, meant: tuple[acts.TeacherAct, ...]) -> str:
    """Return how a guess is asked about; an answer as the answer to its question."""
    state = dialogue.state
    only = meant[0] if len(meant) == 1 else None
    if isinstance(state, Introducing) and isinstance(only, acts.Inform):
        plain = isinstance(only.value, str) or (state.asked == "objects" and not state.index)
        return f"{TOPIC}.{state.asked}" if plain else TOPIC
    return TOPIC


def _of_what_was_asked(dialogue: Dialogue, act: acts.TeacherAct) -> acts.TeacherAct:
    """Return a place told of no thing as one of the thing asked about."""
    state = dialogue.state
    if isinstance(state, Introducing) and isinstance(act, acts.SetPose) and not act.object:
        return replace(act, object=state.thing)
    if isinstance(act, acts.SetPose):
        return replace(act, object=thing_meant(dialogue, act) or act.object)
    return act


def _told(act: acts.TeacherAct, text: str) -> dict[str, object]:
    """Return an act as plain values, an answer with the capitals it was typed with."""
    plain = act_to_json(act)
    if isinstance(act, acts.Inform) and isinstance(act.value, str):
        plain["value"] = as_said(act.value, text)
    return plain


def _asked_between(dialogue: Dialogue, pending: Pending) -> Turn:
    return ask(replace(dialogue, misses=dialogue.misses + 1, pending=pending))


def _steps_listed(dialogue: Dialogue, words: Words) -> Turn | None:
    """Ask whether a list of words that no grammar knows are the steps asked for."""
    state = dialogue.state
    if not isinstance(state, Introducing) or state.asked not in ("subtask_count", "subtask_name"):
        return None
    # "How many? Well, you take it, and ..." answers after the question.
    text = words.text.rpartition("?")[2]
    steps = steps_in(text, 2, dialogue.language)
    told = dict.fromkeys(steps)
    plain = all(len(step.split()) <= LONGEST_STEP for step in steps) and bool(text.strip())
    if state.named or len(told) < len(steps) or not plain:
        return None
    verb_first = bool(steps) and begins_or_ends_with_verb(steps[0], dialogue.language)
    if len(told) < FEWEST_STEPS - verb_first:
        return None
    question = line("confirm", "listed_steps", asked="did_you_mean", names=list(steps))
    pending = Pending("did_you_mean", question, (acts.Inform(steps),), words.text)
    return _asked_between(dialogue, pending)


def _place_shown(dialogue: Dialogue, meant: tuple[acts.TeacherAct, ...]) -> Turn | None:
    """Offer a place, or to see it from the demonstration, to who does not tell one."""
    state, pending = dialogue.state, dialogue.pending
    if not isinstance(state, Introducing) or state.asked != "pose" or pending is not None:
        return None
    if not all(isinstance(act, _NO_PLACE) for act in meant):
        return None
    spot = offered(replace(dialogue, misses=dialogue.misses + 1), state.thing)
    if spot is not None:
        return spot
    question = line("confirm", "place_shown", asked="did_you_mean", thing=state.thing)
    return _asked_between(dialogue, Pending("did_you_mean", question, (acts.Deny(),)))


def _taking_words(dialogue: Dialogue, words: Words) -> Turn | None:
    """Ask whether the words were the answer, where it may be any words."""
    state, asked = dialogue.state, question(dialogue)
    open_ = isinstance(state, Introducing) and asked is not None and asked.asked == state.asked
    if not open_ or asked is None or asked.asked not in IN_ANY_WORDS:
        return None
    text = tidy(words.text, dialogue.language)
    odd = asked.asked == "task_name" and is_odd(text, dialogue.language)
    if not text or len(text.split()) > LONGEST_ANSWER or odd or "?" in words.text:
        return None
    if asked.asked == "objects":
        return _taking_things(dialogue, text)
    taking = line("confirm", "take_words", asked="did_you_mean", words=text)
    return ask(replace(dialogue, pending=Pending("did_you_mean", taking, (acts.Inform(text),))))


def _things_told(
    dialogue: Dialogue, meant: tuple[acts.TeacherAct, ...], words: Words
) -> Turn | None:
    """Ask whether what an unclear answer names are the things; where it names none, say so."""
    state = dialogue.state
    if not isinstance(state, Introducing) or state.asked != "objects" or state.index:
        return None
    if not all(isinstance(act, acts.Inform) for act in meant) or not _fresh(dialogue, meant):
        return None
    free = replace(without_guess(dialogue), misses=dialogue.misses + 1)
    return _taking_things(free, words.text) or misunderstood(dialogue, words)


def _taking_things(dialogue: Dialogue, text: str) -> Turn | None:
    """Ask whether the things that words may name are those; who tells where one is names none."""
    text = without_relative(text, dialogue.language)
    if mentions(text, hints("standing", dialogue.language)):
        return None
    named = tuple(one.name for one in things_in(text, dialogue.known.scene, dialogue.language))
    if not named or any(len(name.split()) > LONGEST_THING for name in named):
        return None
    act = acts.Inform(named)
    guess = line("confirm", f"{TOPIC}.objects", asked="did_you_mean", acts=[act_to_json(act)])
    return ask(replace(dialogue, pending=Pending("did_you_mean", guess, (act,), text)))
