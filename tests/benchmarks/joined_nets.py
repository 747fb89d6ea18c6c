"""Several nets side by side as one: what each says counts alike.

Nets that begin with other weights err at other sentences. As scores are averaged before they
become chances, nets side by side are again one net, whose parts do not see each other.

Source: averages of nets (Hansen and Salamon 1990).
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from assistant.language.nets import ACT_WINDOWS, MARKS, TAG_REACH, Net, Scores

_Weights = Mapping[str, Scores]


def joined_acts(nets: Sequence[Net]) -> Net:
    """Return nets of acts as one: the mean of their scores."""
    told = [one.weights for one in nets]
    found = {"own": _beside(told, "own")}
    counts = []
    for width in ACT_WINDOWS:
        key = f"see{width}"
        rows = [_by_place(one[key], width) for one in told]
        found[key] = _over_words(rows, told[0]["own"].shape[1], 0)
        found[f"{key}_from"] = _beside(told, f"{key}_from")
        counts.append(told[0][key].shape[1])
    ends = np.cumsum(counts)
    parts = [np.split(one["inner"], ends) for one in told]
    blocks = [_blocks([one[n] for one in parts]) for n in range(len(ends))]
    found["inner"] = np.concatenate([*blocks, np.concatenate([one[-1] for one in parts], 1)])
    found["inner_from"] = _beside(told, "inner_from")
    label = np.concatenate([one["label"] for one in told]) / len(told)
    found["label"] = np.asarray(label, np.float32)
    for key in ("label_from", "context"):
        found[key] = _mean(told, key)
    return Net(found, nets[0].context)


def joined_tags(nets: Sequence[Net]) -> Net:
    """Return nets of tags as one: the mean of their scores."""
    told = [one.weights for one in nets]
    span, own = 2 * TAG_REACH + 1, told[0]["own"].shape[1]
    found = {"own": _beside(told, "own")}
    near = [_by_place(one["near"], span) for one in told]
    found["near"] = _over_words(near, own, MARKS)
    far = [_by_place(one["far"], span) for one in told]
    found["far"] = np.concatenate([_blocks([one[n] for one in far]) for n in range(span)])
    for key in ("near_context", "far_context"):
        found[key] = _beside(told, key)
    inner = told[0]["near"].shape[1], told[0]["near"].shape[1] + told[0]["far"].shape[1]
    parts = [np.split(one["tag"], inner) for one in told]
    size = np.float32(len(told))
    seen = [np.concatenate([one[n] for one in parts]) / size for n in (0, 1)]
    wide = len(parts[0][2]) - own - MARKS
    words = [np.split(one[2] / size, [wide, wide + own]) for one in parts]
    shared = [np.asarray(np.sum([one[n] for one in words], axis=0)) for n in (0, 2)]
    found["tag"] = np.concatenate([*seen, shared[0], *(one[1] for one in words), shared[1]])
    found["tag_context"] = _mean(told, "tag_context")
    return Net(found, nets[0].context)


def _by_place(told: Scores, places: int) -> list[Scores]:
    return np.split(told, places)


def _over_words(rows: Sequence[Sequence[Scores]], own: int, marks: int) -> Scores:
    """Return weights of windows: the vectors of words are shared, what was learned is not."""
    found = []
    for parts in zip(*rows, strict=True):
        wide = len(parts[0]) - own - marks
        shared = np.concatenate([one[:wide] for one in parts], axis=1)
        behind = np.concatenate([one[wide + own :] for one in parts], axis=1)
        found += [shared, _blocks([one[wide : wide + own] for one in parts]), behind]
    return np.concatenate(found)


def _blocks(parts: Sequence[Scores]) -> Scores:
    """Return matrices along a diagonal."""
    found = np.zeros((sum(len(one) for one in parts), sum(one.shape[1] for one in parts)))
    row = column = 0
    for one in parts:
        found[row : row + len(one), column : column + one.shape[1]] = one
        row, column = row + len(one), column + one.shape[1]
    return np.asarray(found, np.float32)


def _beside(told: Sequence[_Weights], key: str) -> Scores:
    return np.concatenate([one[key] for one in told], axis=-1)


def _mean(told: Sequence[_Weights], key: str) -> Scores:
    return np.asarray(np.mean([one[key] for one in told], axis=0), np.float32)
