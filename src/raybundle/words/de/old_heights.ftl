old_heights-too_few = Die Einpassung braucht { $needed } unbewegte Zellen; es sind { $n }.
    .do = Ein größeres Gebiet mit { OPTION("stable", "FILE") } angeben, oder ein anderes Modell.

old_heights-not_converged = Das andere Modell lässt sich nicht einpassen: Verschiebung in der Lage zu groß ({ LIST($shift, most: 2) }).
    .why = Neigungen zeigen Verschiebungen von einigen Zellen von { $cell }.
    .do = Sein Koordinatensystem prüfen, oder ein unbewegtes Gebiet mit { OPTION("stable", "FILE") } angeben.

old_heights-not_determined = Das stabile Gebiet bestimmt Verschiebung und Neigungen des anderen Modells nicht.
    .why = Es liegt entlang einer Linie oder ist eben.
    .do = Ein Gebiet mit Hängen in mehreren Richtungen mit { OPTION("stable", "FILE") } angeben.

old_heights-plan_undetermined = Das stabile Gebiet bestimmt die Verschiebung in Richtung { NUM($direction_deg, digits: 3) }° nicht: Sigma { NUM($sigma, digits: 2) } (Grenze { NUM($limit, digits: 2) }).
    .why = Der Winkel zählt im Uhrzeigersinn von oben. Nur Hänge in dieser Richtung zeigen sie; die Grenze ist eine Zelle.
    .do = Ein Gebiet mit solchen Hängen mit { OPTION("stable", "FILE") } angeben.

old_heights-no_map = Ein Modell ohne Fotos braucht eine Oberfläche in einer Karte in Metern.
    .do = Die Oberfläche mit einem Koordinatensystem rechnen (raybundle surface, Passpunkte oder Positionen mit einem).

old_heights-not_needed = { OPTION("stable", "FILE") } gilt einem Modell ohne Fotos.
    .why = Zwei Oberflächen liegen im Rahmen ihrer Passpunkte.

old_heights-cloud_cut_off = Die Punktwolke ist abgeschnitten: { $missing } von { $total } Punkten fehlen.
    .do = Die Datei erneut kopieren.

old_heights-ambiguous = Zwei Einpassungen des anderen Modells passen gleich gut: Was stabil ist, ist nicht sicher.
    .why = Fast die Hälfte hat sich gleich bewegt.
    .do = Das stabile Gebiet mit { OPTION("stable", "FILE") } angeben.

old_heights-narrow = Die Einpassung beruht auf { PERCENT($share) } % der gemeinsamen Höhen (Grenze { PERCENT($limit) } %).
    .why = Sie gilt nur, wenn sich weniger als { PERCENT($moved) } % gleich bewegt haben.
    .do = Das stabile Gebiet mit { OPTION("stable", "FILE") } angeben.

old_heights-far = Das andere Modell liegt in der Höhe { NUM($up, digits: 4) } m daneben (Grenze { NUM($limit, digits: 3) } m).
    .why = Höhenbezüge unterscheiden sich um weniger.
    .do = Einheit und Höhenbezug beider prüfen.

old_heights-other_unit = Das andere Modell hat eine andere Einheit: seine Höhenunterschiede sind { NUM($ratio, digits: 3) } mal so groß.
    .why = { $feet ->
        [yes] Ein Meter hat 3,28 Fuß.
       *[other] Ein Fuß hat 0,305 Meter.
     }
    .do = Das Modell in der Einheit der Oberfläche angeben.

old_heights-whole_units = Die Höhen des anderen Modells sind auf ganze Einheiten gerundet.
    .why = Gerundete Höhen bestimmen weder Neigungen noch die Verschiebung in der Lage.
    .do = Das Modell mit Nachkommastellen angeben.
