"""What is done with the teacher's words: safety first, then doubt, then meaning."""

from __future__ import annotations

from dataclasses import replace

from assistant.dialogue import heard_names, keeping, practicing, showing
from assistant.dialogue.asides import aside
from assistant.dialogue.asking import ask, tell
from assistant.dialogue.changing import shown_left
from assistant.dialogue.declining import denied
from assistant.dialogue.doubting import doubted, is_guess, misunderstood, without_guess
from assistant.dialogue.effects import Effect, Keep
from assistant.dialogue.events import Heard
from assistant.dialogue.explaining import explain
from assistant.dialogue.finding import fully_named, with_name
from assistant.dialogue.fresh import fresh
from assistant.dialogue.general import general
from assistant.dialogue.grounding import names_known, two_ways
from assistant.dialogue.helping import help_line, patient
from assistant.dialogue.naming import number_of, text_of, tidy_name
from assistant.dialogue.otherwise import (
    guessed_other,
    named_other,
    remembered,
    taken_back,
    wants_other,
)
from assistant.dialogue.plain_answers import (
    answers_plainly,
    counted_steps,
    in_own_words,
    tells_body,
    told_steps,
)
from assistant.dialogue.recounting import show
from assistant.dialogue.replying import in_state
from assistant.dialogue.requests import requested
from assistant.dialogue.slips import BEGIN_ANEW
from assistant.dialogue.state import (
    Closed,
    Dialogue,
    Opening,
    Pending,
    Watching,
)
from assistant.dialogue.turn import (
    Turn,
    Words,
    changed,
    first,
    in_full,
    in_order,
    line,
    one_question,
    say,
    with_other,
)
from assistant.dialogue.unknowing import unknowing, unknown_to
from assistant.dialogue.wondering import asks_why, wondered
from assistant.language.hints import hints, mentions
from assistant.language.slips import stands
from assistant.model import teacher_acts as acts
from assistant.model.settings import SafetySettings

SAFETY = SafetySettings()


def hear(dialogue: Dialogue, event: Heard) -> Turn:
    """Answer an utterance."""
    if isinstance(dialogue.state, Opening | Closed):
        return dialogue, ()
    meant = fully_named(dialogue, in_order(event.understanding.acts), event.text)
    words = Words(event.text.strip(), event.by_voice)
    if any(isinstance(act, acts.Stop) for act in meant):
        return _stop(dialogue)
    heard = heard_names.to_read_back(dialogue, event, meant)
    if heard:
        return heard_names.read_back(dialogue, meant, heard, words)
    turn = _by_words(dialogue, meant, words) or _told_plainly(dialogue, event, meant, words)
    return remembered(dialogue, turn or _by_meaning(dialogue, event, meant, words))


def _by_words(dialogue: Dialogue, meant: tuple[acts.TeacherAct, ...], words: Words) -> Turn | None:
    """Answer what its words alone tell, whatever the understanding makes of them."""
    turn = wondered(dialogue, words)
    turn = turn or aside(dialogue, words, meant) or requested(dialogue, words)
    if turn is not None:
        dropped = dialogue.pending is not None and turn[0].pending is None
        return one_question(first(_left_aside(dialogue) if dropped else (), turn))
    if wants_other(dialogue, words.text):
        return one_question(_other_one(dialogue))
    named = named_other(dialogue, words.text)
    if named is not None and dialogue.other is not None:
        back, effects = taken_back(dialogue, dialogue.other)
        both = Words(f"{dialogue.other.words}; {words.text}")
        return one_question(first(effects, act_on(back, named, both)))
    if two_ways(dialogue, words.text, meant):
        turned = (acts.Translate("right"),)
        return doubted(replace(dialogue, misses=0), turned, words, other=meant)
    if unknowing(dialogue, words.text):
        return one_question(unknown_to(dialogue, words))
    return None


def _other_one(dialogue: Dialogue) -> Turn:
    """Take the second-best reading of a guess, or the other of two candidates."""
    other = dialogue.other
    if is_guess(dialogue.pending) or other is None:
        return guessed_other(dialogue)
    back, effects = taken_back(dialogue, other)
    return first(effects, act_on_all(back, other.acts, Words(other.words)))


def _told_plainly(
    dialogue: Dialogue, event: Heard, meant: tuple[acts.TeacherAct, ...], words: Words
) -> Turn | None:
    """Answer a list of steps, or a size, that was asked for."""
    counted = counted_steps(dialogue, words.text, meant)
    if counted and not heard_names.misheard(event):
        return one_question(act_on_all(dialogue, counted, words))
    steps = told_steps(dialogue, words.text, meant)
    if steps and heard_names.misheard(event):
        return heard_names.read_back(dialogue, (acts.Inform(steps),), steps, words)
    if steps:
        return one_question(act_on_all(dialogue, (acts.Inform(steps),), words))
    answering = without_guess(dialogue)
    if tells_body(answering, meant):
        return one_question(patient(dialogue, act_on(answering, acts.Inform(words.text), words)))
    return None


def _by_meaning(
    dialogue: Dialogue, event: Heard, meant: tuple[acts.TeacherAct, ...], words: Words
) -> Turn:
    """Do what was understood, or ask whether it was meant."""
    unsure = event.understanding.confidence < SAFETY.act_confidence
    meant = in_own_words(dialogue, meant, words.text) if unsure else meant
    plain = answers_plainly(without_guess(dialogue), meant, words.text) or (
        # What changes the plan must have been heard well.
        names_known(dialogue, meant) and not heard_names.misheard(event)
    )
    if unsure and not plain and not asks_why(dialogue, meant, words.text):
        return doubted(dialogue, meant, words)
    return one_question(patient(dialogue, act_on_all(dialogue, meant, words)))


def _stop(dialogue: Dialogue) -> Turn:
    if isinstance(dialogue.state, Watching):
        return showing.while_watching(dialogue, acts.Stop())
    return practicing.stop(replace(dialogue, pending=None))


def act_on_all(dialogue: Dialogue, meant: tuple[acts.TeacherAct, ...], words: Words) -> Turn:
    """Do several acts in turn; what comes after a question waits for its answer."""
    effects: tuple[Effect, ...] = ()
    for at, act in enumerate(meant):
        if isinstance(act, acts.Quit) and any(isinstance(one, Keep) for one in effects):
            # "Save it and goodbye": who leaves waits until it is kept.
            return replace(dialogue, leaving=True), effects
        before = dialogue.pending
        dialogue, more = act_on(dialogue, act, words)
        effects = (*effects, *more)
        waiting = dialogue.pending
        if waiting is not None and waiting is not before and meant[at + 1 :]:
            rest = (*waiting.acts, *meant[at + 1 :])
            return replace(dialogue, pending=replace(waiting, acts=rest)), effects
    return dialogue, effects


def act_on(dialogue: Dialogue, act: acts.TeacherAct, words: Words) -> Turn:
    """Do one act: what works everywhere first, then what the state makes of it."""
    if isinstance(act, acts.Unknown):
        return misunderstood(dialogue, words)
    heard = replace(dialogue, misses=0)
    anywhere = _anywhere(heard, act, words)
    if anywhere is not None:
        return anywhere
    watching = isinstance(dialogue.state, Watching)
    told: tuple[Effect, ...] = ()
    if dialogue.pending is not None and (not watching or dialogue.pending.leave):
        if (answered := _answer_pending(heard, act, words)) is not None:
            return answered
        told = _left_aside(heard)
        heard = replace(heard, pending=None)
    if watching:
        return showing.while_watching(heard, act)
    return first(told, general(heard, act, words) or in_state(heard, act, words))


def _left_aside(dialogue: Dialogue) -> tuple[Effect, ...]:
    """Tell who goes on to something else that what was asked about is not done."""
    pending = dialogue.pending
    if pending is None or is_guess(pending) or not pending.acts:
        return ()
    return say(dialogue, line("told", "left_aside"))[1]


def _anywhere(dialogue: Dialogue, act: acts.TeacherAct, words: Words) -> Turn | None:
    """Answer what may be said in every state and changes nothing that is taught."""
    match act:
        case acts.Help():
            return tell(dialogue, help_line(dialogue))
        case acts.RepeatLine():
            return say(dialogue, *map(in_full, dialogue.said)) if dialogue.said else ask(dialogue)
        case acts.Explain():
            # "Why?" asks about a guess that was read back; any other question lets it go.
            plain = tidy_name(words.text).lower() in hints("why_not", dialogue.language)
            return explain(dialogue if plain else without_guess(dialogue), act)
        case acts.Show() if mentions(words.text, hints("questions", dialogue.language)):
            return explain(without_guess(dialogue), acts.Explain(words.text))
        case acts.Show():
            return show(without_guess(dialogue), act)
        case acts.BeBrief() | acts.BeThorough():
            brief = isinstance(act, acts.BeBrief)
            topic = "brief" if brief else "thorough"
            return tell(replace(dialogue, brief=brief), line("told", topic))
        case acts.Stop():
            return _stop(dialogue)
        case acts.Quit() if not (isinstance(dialogue.state, Watching) and words.by_voice):
            # Whoever says it twice has been asked about what is not saved already.
            leaving = dialogue.pending is not None and dialogue.pending.leave
            return None if leaving else keeping.leave_wanted(dialogue)
        case _:
            return None


def _answer_pending(dialogue: Dialogue, act: acts.TeacherAct, words: Words) -> Turn | None:
    """Answer a question in between; None if the teacher went on to something else."""
    pending = dialogue.pending
    if pending is None:
        return None
    if pending.asked == "unsaved":
        return keeping.answer_unsaved(dialogue, act)
    free = replace(dialogue, pending=pending.over)
    if pending.line.topic == showing.FORGET:
        return showing.begun(dialogue, act)
    if pending.asked == "facing":
        return _faced(free, pending, act, words)
    if pending.asked == "which" and isinstance(act, acts.Inform):
        return _chosen(free, pending, text_of(act.value), words)
    confirmed = Words(pending.words or words.text, words.by_voice, sure=True)
    match act:
        case acts.Start() if is_guess(pending) and set(map(type, pending.acts)) == {acts.Deny}:
            # "Did you mean: no?" is not said yes to by "go".
            return None
        case acts.Affirm() | acts.Approve() | acts.Start() if pending.line.topic == BEGIN_ANEW:
            return fresh(free)
        case acts.Affirm() | acts.Approve() | acts.Start():
            return practicing.begun_until(act_on_all(free, pending.acts, confirmed), pending.line)
        case acts.Undo() if is_guess(pending):
            # "Scratch that" to a guess takes the guess back, not what was done before.
            return tell(free, line("told", "as_it_was"))
        case acts.Deny():
            return denied(dialogue, pending)
        case _:
            return None


def _chosen(dialogue: Dialogue, pending: Pending, text: str, words: Words) -> Turn:
    """Take the one the teacher meant of several steps."""
    offered: list[str] = pending.line.slots["names"]
    number = number_of(text, dialogue.language)
    if number is not None and 1 <= number <= len(offered):
        names = [offered[number - 1]]
    else:
        exact = [name for name in offered if name.lower() == text.lower()]
        names = exact or [name for name in offered if text.lower() in name.lower()]
    if len(names) != 1:
        told = line("error", "not_among", names=offered)
        return tell(replace(dialogue, pending=pending), told)
    chosen = tuple(with_name(act, pending.words, names[0]) for act in pending.acts)
    done = act_on_all(dialogue, chosen, words)
    if len(offered) != 2:
        return done
    other = offered[1 - offered.index(names[0])]
    instead = tuple(with_name(act, pending.words, other) for act in pending.acts)
    return with_other(dialogue, done[0], instead, words), done[1]


def _faced(dialogue: Dialogue, pending: Pending, act: acts.TeacherAct, words: Words) -> Turn:
    """Take where the teacher stands; whoever does not say stands as the robot looks."""
    text = words.text if not isinstance(act, acts.Inform) else str(act.value)
    told = stands(text, dialogue.language)
    if not told and isinstance(act, acts.Inform) and not pending.line.slots.get("twice"):
        twice = replace(pending, line=line("ask", "facing", asked="facing", twice=True))
        again = replace(dialogue, pending=twice)
        return tell(again, help_line(again))
    facing = "facing" if told == "facing" else "own"
    known = replace(dialogue.known, facing="facing" if facing == "facing" else "own")
    standing = changed(dialogue, "facing", known, clean=dialogue.clean)
    waiting = Words(pending.words, words.by_voice, sure=words.sure)
    said = say(standing, line("told", f"facing_{facing}"))[1]
    shown = shown_left(standing)
    # A place told by another thing is no act of its own: its words are heard again.
    rest = None if pending.acts else requested(shown[0], waiting)
    done = first((*said, *shown[1]), rest or act_on_all(shown[0], pending.acts, waiting))
    if told or isinstance(act, acts.Inform | acts.Affirm | acts.Deny):
        return done
    return first(done[1], act_on(done[0], act, words))
