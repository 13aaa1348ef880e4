"""Progress of what is done in rounds, and of what waits."""

import json

from tests.blocking.networks import flight

from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.cli.progress import reporting
from raybundle.numerics.progress import Counted, Remark, in_rounds
from raybundle.pipeline.stage import Counting
from raybundle.workflows.adjust import adjust


def test_shares_of_an_adjustment_rise_within_each_round():
    said = []
    adjust(
        flight(), AdjustmentOptions(reject="snooping"), progress=lambda stage, share: said.append((stage, float(share)))
    )
    stages = {stage for stage, _ in said}
    assert {"adjusting", "adjusting, round 2"} <= stages
    for stage in stages:
        shares = [share for name, share in said if name == stage]
        assert shares == sorted(shares), stage


def test_a_round_has_its_number_and_a_remark_none():
    said = []
    tell = in_rounds(lambda stage, _: said.append(stage))
    for stage, share in (("a", 0.2), ("b", 0.5), ("a", 0.9), ("w", Remark()), ("a", 0.1), ("b", 0.6), ("a", 0.05)):
        tell(stage, share)
    assert said == ["a", "b", "a", "w", "a, round 2", "b", "a, round 3"]


def test_share_and_number_of_tasks_agree_and_remarks_are_lines_of_their_own(capsys):
    with reporting("json") as tell:
        Counting(tell, "pairs", total=4, done=1, costs=()).one_more(1.0)
        tell("no worker", Remark())
        tell("pairs", Counted(0.5, 2, 4, 1.0))
    first, remark, last = map(json.loads, capsys.readouterr().err.splitlines())
    assert first["share"] == first["done"] / first["total"] == 0.5
    assert remark["remark"] == "no worker"
    assert "share" not in remark
    assert last["stage"] == "pairs"
