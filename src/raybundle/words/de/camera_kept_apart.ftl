camera_kept_apart-not_adjusted = Kamera { $camera }: { $n } von { $photographs } Aufnahmen ({ $width_px } x { $height_px } px) ließen sich nicht mit den anderen ausgleichen.
    .why = Diese Aufnahmen sind { $turned ->
        [yes] gedreht gespeichert
       *[no] anders groß
    }{ $reduced ->
        [yes] {" "}und verkleinert
       *[no] {""}
    } und gehören jetzt zur Kamera { $other }.
    .do = Die Dateien so angeben, wie die Kamera sie speicherte.

camera_kept_apart = Kamera { $camera }: { $n } von { $photographs } Aufnahmen ({ $width_px } x { $height_px } px) haben eine andere innere Orientierung.
    .why = Diese Aufnahmen sind { $turned ->
        [yes] gedreht gespeichert
       *[no] anders groß
    }{ $reduced ->
        [yes] {" "}und verkleinert
       *[no] {""}
    }; Fokus, Zoom oder Ausschnitt änderten sich (Chi-Quadrat { NUM($chi_square, decimals: 1) } bei { $dof }). Diese Aufnahmen gehören jetzt zur Kamera { $other }.
    .do = Die Dateien so angeben, wie die Kamera sie speicherte.
