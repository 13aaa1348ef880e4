"""No praise by a test that weights from the same residuals must pass."""

from dataclasses import replace

from raybundle.adjustment.engine import adjust_block
from raybundle.adjustment.records.options import AdjustmentOptions
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import Ring, ring_scene
from raybundle.report.text.words import verdict
from raybundle.report.view import view_of


def too_small(weights):
    block = simulate(ring_scene(Ring(stations=6, points=80)), Survey(image_sigma_px=0.1, points="approximate")).observed
    o = block.observations
    wide = replace(block, observations=replace(o, cov_px2=4 * o.cov_px2))
    result = adjust_block(wide, AdjustmentOptions(weights=weights))
    assert result.global_test[1] < result.global_test[0]
    return result


def test_residuals_below_weights_that_were_taken_from_them_are_no_merit():
    for weights, praised in (("given", True), ("residuals", False)):
        result = too_small(weights)
        (notice,) = (n for n in result.notices if n.code == "global_test")
        assert notice.data.code == ("global_test.smaller" if praised else "global_test.estimated_weights")
        told = verdict(view_of(result))
        codes = {m.code for text in (told.headline, *(s for _, s in told.statements)) for m in text.messages}
        assert ("verdict.fit_smaller" in codes) is praised
        assert "verdict.fits_better" not in codes or praised
