# %% The figures of the report in Python:
import numpy as np
from raybundle import adjust, write_report
from raybundle.planning.synthetic_networks import TargetField, field_scene
from raybundle.planning.simulate import Survey, simulate

result = adjust(simulate(field_scene(TargetField(rows=6, columns=8)), Survey(scale_bars=1)).observed)
low, value, high = result.global_test
r = result.image_observations.redundancy
bars = sum(np.sum(g.redundancy) for g in result.groups)
assert low < value < 2 * high
assert abs(np.nansum(r) + bars - result.redundancy) < 1e-6
assert [c.kind for c in result.variance_components[:3]]
assert result.network.relative_precision > 0
write_report(result, "report.html")
write_report(result, "report.pdf", appendix="all")
