orientation_fix-count = Anzahl der Orientierungsstützpunkte: { $n }.
    .do = 2 bis { $most } Stützpunkte angeben.

orientation_fix-time_order = Die Zeit des Orientierungsstützpunkts { $later } liegt nicht nach der von { $earlier }.
    .do = Die Stützpunkte nach der Zeit ordnen.

orientation_fix-outside_image = Alle Orientierungsstützpunkte liegen vor der ersten oder nach der letzten Bildzeile.
    .do = Stützpunkte innerhalb des Bildes angeben.
