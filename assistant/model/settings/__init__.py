"""Numbers the method depends on, each with its source."""

from assistant.model.settings.paths import (
    BlendingSettings,
    GeneralizationSettings,
    SmoothingSettings,
)
from assistant.model.settings.safety import (
    PracticeSettings,
    SafetySettings,
)
from assistant.model.settings.segmentation import (
    PAPER_VOTES,
    DecodingSettings,
    SegmentationSettings,
    ValiditySettings,
    VoteSettings,
    paper,
)
from assistant.model.settings.signals import (
    CueSettings,
    JoltSettings,
    SignalSettings,
)

__all__ = [
    "PAPER_VOTES",
    "BlendingSettings",
    "CueSettings",
    "DecodingSettings",
    "GeneralizationSettings",
    "JoltSettings",
    "PracticeSettings",
    "SafetySettings",
    "SegmentationSettings",
    "SignalSettings",
    "SmoothingSettings",
    "ValiditySettings",
    "VoteSettings",
    "paper",
]
