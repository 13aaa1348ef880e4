# %% the photographs of the facade are of another camera, and this is its calibration:
from pathlib import Path

truth = Path("demo_data/portal/truth/block.toml").read_text()
Path("calibration/calibration.toml").write_text(truth[truth.index("[cameras") :])
