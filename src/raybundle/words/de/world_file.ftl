world_file-six_numbers = Eine World-Datei hat sechs Zahlen, eine je Zeile.
    .do = Die Datei korrigieren.

world_file-rotated = Die Pixel sind nicht quadratisch, oder das Bild ist gedreht.
    .do = Ein Bild mit Spalten nach rechts und Zeilen nach unten angeben.
