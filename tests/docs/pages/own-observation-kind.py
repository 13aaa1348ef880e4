# %% Transformation, and messages of rows that cannot follow
from raybundle.numerics.rotation import rotation_from_angles
from raybundle.numerics.transform import SimilarityTransform

table = block.tables["azimuths"]
turned = SimilarityTransform(rotation=rotation_from_angles(np.array([0.0, 0.0, 0.3])))  # clockwise, seen from above
again = adjust(transform_block(block, turned, observed="follow"))
(h,) = [h for h in again.groups if h.kind == "azimuth"]
assert np.allclose((h.adjusted - g.adjusted) % (2 * np.pi), 0.3, atol=1e-7)
assert np.allclose(h.residual, g.residual, atol=1e-8)
try:
    table.transformed(SimilarityTransform(rotation=rotation_from_angles(np.array([0.1, 0.0, 0.0]))))
except InputError as error:
    print(error)
text = Path("field/azimuths.csv").read_text()
Path("field/azimuths.csv").write_text(text.replace(f"{ids[0]},{ids[15]},", f"{ids[0]},{ids[0]},"))
try:
    read_block("field")
except InputError as error:
    print(error)
# %% Partial derivatives, and errors over standard deviations
from scipy.stats import chi2

from raybundle.adjustment.observation_contract import partials_off

assert partials_off(result.adjusted, "azimuth") < 1e-6

true = made.truth.having(replace(table, angle=azimuth[: len(table)] % (2 * np.pi)))
o, runs = true.observations, 60


def squares(stated):
    """Of the errors of an adjusted azimuth, when errors of 0.02 deg are stated as so much."""
    found = []
    for _ in range(runs):
        noise = rng.normal(0, 0.5, o.xy_px.shape)
        again = replace(true, observations=replace(o, xy_px=o.xy_px + noise)).of_tables(lambda t: t.with_errors(rng))
        azimuths = replace(again.tables["azimuths"], sigma=np.full(len(table), np.radians(stated)))
        (g,) = [g for g in adjust(again.having(azimuths)).groups if g.kind == "azimuth"]
        off = g.adjusted[0] - azimuth[0]
        found.append((np.arctan2(np.sin(off), np.cos(off)) / g.adjusted_std[0]) ** 2)
    return sum(found)


low, high = chi2(runs).interval(0.999)
assert low < squares(0.02) < high
assert squares(0.01) > high
