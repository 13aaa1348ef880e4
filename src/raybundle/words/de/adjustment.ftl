adjustment-corrected_residuals = Kamera { $camera }: Verbesserungen korrigierter Bildkoordinaten gibt es nur für das Modell brown, nicht für { $model }.
    .do = residuals = "measured" verwenden.

adjustment-no_point = Kein Objektpunkt geht in die Ausgleichung ein.
    .why = Alle Punkte liegen hinter den Kameras, die sie messen, oder haben keinen Strahl.
    .do = Die gegebenen Orientierungen sowie Vorzeichen und Einheit der Kamerakonstante prüfen oder die Orientierungen weglassen.

adjustment-options_type = Die Optionen sind vom Typ { $type }, nicht AdjustmentOptions.
    .do = AdjustmentOptions(...) übergeben.

adjustment-block_type = Der Block ist vom Typ { $type }, nicht Block.
    .do = Den Block mit raybundle.read_block(path) lesen.

adjustment-option_choice = Die Option { $name } ist { $given }.
    .do = Einen Wert von { LIST($known, most: 12) } verwenden.

adjustment-option_not_bool = Die Option { $name } ist { $given }; sie muss True oder False sein.
    .do = { $name }=True oder { $name }=False angeben.

adjustment-option_not_names = Die Option { $name } ist { $given }; sie muss ein Tupel von { $pairs ->
        [yes] Namenspaaren
       *[no] Namen
     } sein.
    .do = Zum Beispiel { $name }={ $pairs ->
            [yes] (("d5100", "c"),)
            *[no] ("P1", "P2")
        } angeben.

adjustment-option_range = Die Option { $name } ist { $given }; sie muss eine { $whole ->
        [yes] ganze Zahl
       *[no] Zahl
     } von { $low } bis { $high } sein.
    .do = Für { $name } eine Zahl in diesen Grenzen angeben.

adjustment-no_statistics = Dieses Ergebnis hat keine Normalgleichungen.
    .why = Es wurde ohne Statistik ausgeglichen oder ist eine Kopie eines Ergebnisses.
    .do = Das ursprüngliche Ergebnis verwenden oder mit AdjustmentOptions(statistics=True) ausgleichen.

adjustment-groups_without_statistics = Varianzfaktoren von Gruppen brauchen Redundanzanteile.
    .do = Mit statistics=True ausgleichen.

adjustment-all_rejected = Block { $block }: Alle { $n } Bildbeobachtungen sind verworfen.
    .do = Prüfen, ob observations.csv die Bilder und Punkte dieses Blocks nennt.

adjustment-no_observation = Block { $block } hat keine Bildbeobachtungen.
    .do = Prüfen, ob observations.csv die Bilder und Punkte dieses Blocks nennt.

adjustment-too_few_observations = { $n } Beobachtungen bestimmen { $unknowns } Unbekannte nicht; es fehlen { $missing }.
    .why = Für Standardabweichungen sind noch mehr nötig.
    .do = { $free ->
        [0] Mehr Punkte in mehr Bildern messen oder Passpunkte angeben.
       *[other] Einige von { LIST($parameters, most: 10) } festhalten, mehr Punkte in mehr Bildern messen oder Passpunkte angeben.
     }

adjustment-image_points_contradict = Die Bildpunkte widersprechen einander um { PERCENT($share) } % der Bilddiagonale (Grenze { PERCENT($limit) } %).
    .why = Das ist die mittlere Abweichung (Median) von der besten gefundenen Lösung.
    .do = Punkt- und Bildnamen, Einheit und Ursprung der Bildkoordinaten, die Kamerakonstante und die Passpunkte prüfen.

adjustment-not_finite = Keine Konvergenz: Nach { $iterations } Iterationen sind die Normalgleichungen nicht endlich.
    .why = Bildpunkte, Koordinaten oder Näherungswerte sind zu groß.
    .do = Einheiten und Dezimalpunkte prüfen.

adjustment-no_convergence = Keine Konvergenz nach { $iterations } Iterationen (letzter Schritt { NUM($step_sigmas, digits: 2) } Standardabweichungen).
    .why = Meist sind grobe Fehler oder schlechte Näherungswerte die Ursache.
    .do = { OPTION("robust_start", "True") } mit { OPTION("reject", "snooping") } verwenden; Punktnamen der Bildmessungen und Näherungswerte prüfen.

adjustment-identical_images = Keine Konvergenz: { $pairs } { $pairs ->
        [one] Bildpaar hat
       *[other] Bildpaare haben
    } auf ein halbes Pixel dieselben Bildpunkte.
    .why = Es ist zweimal dieselbe Aufnahme, oder es fehlt die Basis.
    .do = Von jedem Paar ein Bild ausschließen.

adjustment-out_missing = Es fehlt, wohin das Ergebnis geschrieben wird: dies ist kein Projekt.
    .do = Einen Ordner angeben: { OPTION("out") }.
