# %%
import raybundle as rb

sheet = rb.write_target_sheet("chessboard-9x6", "board.svg", spacing=24.0, lying=True)
print(len(sheet.pages[0].targets), "points;", rb.choose_targets("aicon12", count=5).ids)

from pathlib import Path

from raybundle.targets.sidecar import read_sidecar

sheet = read_sidecar(Path("fifty.toml"))
print(sheet.family, sheet.dot_radius_mm, len(sheet.targets), sheet.targets[0])

measured = 99.8  # mm, the bar of 100 mm on the print
printed = sheet.scaled(measured / sheet.bar_mm)
assert abs(printed.dot_radius_mm - 4.99) < 1e-9
