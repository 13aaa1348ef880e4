"""What became of the features on their way to the adjustment: why some were dropped, and how many."""

from __future__ import annotations

from dataclasses import dataclass

from raybundle.adjustment.records.notice import Notice
from raybundle.adjustment.records.severity import Severity
from raybundle.adjustment.result import Adjustment

MOST = 0.5
"""Share of the image points with a partner that may be dropped before the adjustment without being a caution."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Dropped:
    """Numbers of image points of photographs, in the order in which they are dropped."""

    features: int
    """found in the photographs"""
    matched: int
    """of which a verified pair shows the same point in another photograph"""
    started: int
    """of these, what the approximate orientation agrees with"""
    measured: int | None = None
    """of these, measured by least-squares matching; None: that was left out"""
    features_kept: int = 0
    """that keep the position of their feature, of photographs in which matching measures too little"""
    added: int = 0
    """measured where no feature was found"""
    adjusted: int = 0
    """that are left to the adjustment, before marks and scenes join them and points without depth leave"""

    @property
    def reasons(self) -> dict[str, int]:
        """Image points dropped before the adjustment, by the reason."""
        left = self.started if self.measured is None else self.measured + self.features_kept + self.added
        found = {
            "without_partner": self.features - self.matched,
            "contradict_orientation": self.matched - self.started,
            "not_measured_precisely": 0 if self.measured is None else self.started - self.measured - self.features_kept,
            "contradict_others": left - self.adjusted,
        }
        return {reason: max(count, 0) for reason, count in found.items()}

    @property
    def share(self) -> float:
        """Of the image points with a partner, what was dropped before the adjustment."""
        lost = sum(count for reason, count in self.reasons.items() if reason != "without_partner")
        return lost / max(self.matched + self.added, 1)

    def as_mapping(self, adjustment: Adjustment) -> dict[str, object]:
        """What result.json states of it."""
        rejected = sum(1 for r in adjustment.image_observations.rejected if r)
        return {
            "features": self.features, "matched": self.matched, "added": self.added,
            "features_kept": self.features_kept, "dropped": self.reasons, "dropped_share": self.share,
            "adjusted": self.adjusted, "given": len(adjustment.given.observations), "rejected": rejected,
        }  # fmt: skip

    def notice(self, given: int) -> Notice:
        """The same as a notice.

        given  image observations of the adjustment, marks and scenes among them
        """
        lost = self.reasons
        values = {
            "share": self.share, "features": self.features, "matched": self.matched, "added": self.added,
            "contradict_orientation": lost["contradict_orientation"],
            "not_measured": lost["not_measured_precisely"], "contradict_others": lost["contradict_others"],
            "adjusted": self.adjusted, "given": given,
        }  # fmt: skip
        grave = Severity.WARNING if self.share > MOST else Severity.NOTE
        return Notice(code="dropped", values=values, measured=grave)
