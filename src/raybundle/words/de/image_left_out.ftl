image_left_out = Bild { $image } ist von der Ausgleichung ausgeschlossen.
