# %%
from pathlib import Path

Path("survey/settings.toml").write_text(
    """
[all]
language = "de"
client = "Monument office"

[adjust]
reject = "snooping"
datum = "inner"
datum-points = ["1", "6", "25"]
no-report = true

[plan.flight]
rtk = [0.02, 0.02, 0.03]
alternate = true
"""
)
