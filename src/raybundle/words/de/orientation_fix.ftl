orientation_fix-count = Anzahl der Stützstellen der Orientierung: { $n }.
    .do = 2 bis { $most } Stützstellen angeben.

orientation_fix-time_order = Stützstelle { $later } der Orientierung: Die Zeit liegt nicht nach der von { $earlier }.
    .do = Die Stützstellen nach der Zeit ordnen.

orientation_fix-outside_image = Alle Stützstellen der Orientierung liegen vor der ersten oder nach der letzten Bildzeile.
    .do = Stützstellen innerhalb des Bildes angeben.
