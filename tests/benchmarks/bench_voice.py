"""How well teachers are heard: one table for each group of clips, printed as it is measured.

Speakers and noises of `tuned` were looked at while thresholds were chosen; those of `reported`
were not. Speech once made and readings once recognized are kept in a folder, so that a run that
was broken off goes on where it was. Folders of recorded people are the reader's own:
``--words`` one whose files or folders are named by the word said, ``--human`` one of speech
that has nothing to do with robots; nothing in it may act.

run: python -m tests.benchmarks.bench_voice [sentences words chat stops people latency ...]
"""

from __future__ import annotations

import argparse
import statistics
import subprocess
import sys
import tempfile
from collections import Counter
from collections.abc import Iterable, Iterator
from itertools import chain
from pathlib import Path

from assistant.model.listening import Understanding
from assistant.model.teacher_acts import act_to_json
from assistant.shells.voice.clips import ClipReader
from assistant.shells.voice.deciding import is_unknown
from assistant.shells.voice.endpointing import EndpointSettings
from assistant.shells.voice.recognized import Recognizer
from assistant.shells.voice.recognizers import installed
from assistant.shells.voice.sound import Sound
from tests.benchmarks import voice_clips
from tests.benchmarks.bench_language import same
from tests.benchmarks.intervals import interval
from tests.benchmarks.remembered import Remembered
from tests.benchmarks.stop_clips import stops_table
from tests.benchmarks.voice_clips import Clip

TABLES = ("sentences", "words", "chat", "people", "stops", "latency")
KEPT = Path(tempfile.gettempdir()) / "voice_benchmark"
MEMORY = """
import time
from pathlib import Path
began = time.process_time()
import numpy as np
from assistant.model.listening import Listening
from assistant.shells.voice.endpointing import silero
from assistant.shells.voice.hearing import Hearing
from assistant.shells.voice.memory import give_back
from assistant.shells.voice.recognizers import installed
from assistant.shells.voice.spotter import StopSpotter
hearing, spotter, activity = Hearing(installed()), StopSpotter(), silero()
loaded = time.process_time() - began
rng = np.random.default_rng(1)
for _ in range(5):
    sound = 0.1 * rng.standard_normal(32000).astype(np.float32)
    hearing.hear(sound, Listening(stage="practice"))
    give_back()
    spotter.hear(sound)
    activity(sound[:512])
# What this process took; the usage the system counts for a child begins with its parent's.
told = Path("/proc/self/status").read_text().partition("VmHWM:")[2]
most_mb = int(told.split()[0]) / 1024
print(f"memory: {most_mb:.0f} MB at most; loading took {loaded:.1f} s of processor time")
"""


def verdict(clip: Clip, heard: Understanding) -> str:
    """Return right, wrong (acted on something else), asked, or nothing (not understood).

    Acted on is what is heard surely, or as surely as it is understood when typed.
    """
    got = [act_to_json(act) for act in heard.acts]
    sure = heard.confidence >= clip.sure - 1e-9
    if is_unknown(heard):
        return "nothing" if clip.acts else "right"
    if clip.acts and same(clip.acts, got):
        return "right" if sure else "asked, right"
    if [act["act"] for act in clip.acts] == [act["act"] for act in got] and sure:
        return "other slots"
    return "wrong" if sure else "asked, wrong"


def table(title: str, told: Iterable[Clip], reader: ClipReader, *, show: bool) -> None:
    """Hear clips and print a row for each kind and engine, and one for all neural voices."""
    counts: dict[tuple[str, str], Counter[str]] = {}
    for clip in told:
        heard = reader.read(Sound(clip.samples), clip.listening)
        found = verdict(clip, heard)
        room = clip.kind.partition(" dB")
        for speaker in rows_of(clip):
            counts.setdefault((f"{room[0]}{room[1]}", speaker), Counter())[found] += 1
        if show and found != "right":
            line = f"  {clip.kind} {clip.speaker}: {clip.text!r} -> {heard.heard!r}: {found}"
            print(line, flush=True)
    print(f"{title}\n{'':<18}{'voices':<12}{'n':>4} right [95 %]")
    for (kind, speaker), found_all in sorted(counts.items()):
        total = found_all.total()
        low, high = interval(found_all["right"], total)
        shares = ", ".join(f"{what} {many}" for what, many in sorted(found_all.items()))
        right = found_all["right"] / total
        row = f"{kind:<18}{speaker:<12}{total:>4} {right:.3f} [{low:.3f}, {high:.3f}] {shares}"
        print(row, flush=True)


def rows_of(clip: Clip) -> Iterator[str]:
    """Yield the rows a clip counts in: its engine's, and all neural engines'."""
    yield clip.speaker
    if clip.speaker in ("piper", "kokoro"):
        yield "neural"


def latency(recognizers: Iterable[Remembered]) -> None:
    """Print what hearing took after the end of speech.

    Recognizing begins ahead of the end: of the silence that ends an utterance and of the
    processor's time behind the first pause, the longer one is waited for.
    """
    settings = EndpointSettings()
    early_s = settings.early_s
    print(f"latency: processor time, begun {early_s:.2f} s after speech; reaction after its end")
    for one in recognizers:
        if one.took_s:
            took_s = statistics.median(one.took_s)
            most_s = sorted(one.took_s)[int(0.95 * (len(one.took_s) - 1))]
            waits = " or ".join(
                f"{max(wait_s, early_s + took_s):.2f}"
                for wait_s in (settings.short_silence_s, settings.silence_s)
            )
            print(f"{one.name:<22}{took_s:.2f} s median, {most_s:.2f} at 95 %; reaction {waits} s")
    subprocess.run([sys.executable, "-c", MEMORY], check=True)


def clips(name: str, args: argparse.Namespace, folder: Path) -> Iterator[Clip]:
    """Yield the clips of a table."""
    match name:
        case "sentences":
            yield from voice_clips.sentences(args.group, args.count, folder)
        case "words":
            yield from voice_clips.words(args.group, max(1, args.count // 20), folder)
        case "chat":
            yield from voice_clips.chat(args.group, args.count, folder)
        case "people":
            words = voice_clips.people_words(args.words) if args.words else ()
            others = voice_clips.people(args.human, args.count) if args.human else ()
            yield from chain(words, others)


def main() -> None:
    """Print the tables asked for, or all."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("tables", nargs="*", choices=[*TABLES, []], help="all if none is named")
    parser.add_argument("--group", choices=("tuned", "reported"), default="reported")
    parser.add_argument("--count", type=int, default=180, help="sentences")
    parser.add_argument("--words", type=Path, help="a folder of words recorded alone")
    parser.add_argument("--human", type=Path, help="a folder of recorded, unrelated speech")
    parser.add_argument("--kept", type=Path, default=KEPT, help="where sound and readings stay")
    parser.add_argument("--show", action="store_true", help="what was not heard right")
    args = parser.parse_args()
    found: tuple[Recognizer, ...] = installed()
    recognizers = [Remembered(one, args.kept) for one in found]
    reader = ClipReader(recognizers=recognizers)
    for name in args.tables or TABLES:
        if name == "stops":
            stops_table(args.group, args.kept / "spoken", reader, args.words, args.human)
        elif name == "latency":
            latency(recognizers)
        else:
            told = clips(name, args, args.kept / "spoken")
            table(f"{name} ({args.group})", told, reader, show=args.show)


if __name__ == "__main__":
    main()
