check_points_open = Kontrollpunkte werden in { $axes } nicht verglichen; nicht bestimmt: { datum-part }.
    .why = Koordinaten, die davon abhängen, sind willkürlich.
