# %%
from pathlib import Path

Path("surveyed.csv").write_text(
    "point,X,Y,Z,sX,sY,sZ,role\nS1,1.5,0.2,3.1,0.01,0.01,0.02,control\nS2,4.0,0.3,3.2,,,,check\n"
)
