rank-not_determined = Die Beobachtungen bestimmen nicht alle Unbekannten.
    .why = Standardabweichungen lassen sich nicht angeben.
    .do = Beobachtungen oder Passpunkte ergänzen oder die unbestimmten Parameter festhalten.

rank-no_observation = { $n } { $n ->
        [one] Unbekannte hat
       *[other] Unbekannte haben
     } keine Beobachtung.
    .do = Diesen Unbekannten ein Sigma oder eine Glattheit geben oder dort Punkte messen.

rank-parallel_rays = Die Strahlen zu { $n } { $n ->
        [one] Objektpunkt
       *[other] Objektpunkten
     } sind parallel oder fallen zusammen: { LIST($points, most: 10) }.
    .do = Diese Punkte von einem weiteren Standpunkt messen.

rank-undetermined_together = Die Beobachtungen bestimmen diese Unbekannten gemeinsam nicht:
    .do = { $parameter ->
        [scale] c festhalten (in `estimate` weglassen) oder konvergente Bilder oder Punkte in verschiedenen Tiefen ergänzen.
        [principal_point] Den Bildhauptpunkt festhalten oder um 90° verkantete Bilder ergänzen.
        [radial] Den Parameter festhalten oder Punkte bis in die Ecken des Formats messen.
        [decentring] Den Parameter festhalten oder um 90° verkantete Bilder ergänzen.
        [affinity] Den Parameter festhalten oder um 90° verkantete Bilder ergänzen.
        [harmonic] Den Parameter festhalten oder in um 90° verkanteten Bildern Punkte bis an die Formatränder messen.
        [read_out] Den Parameter festhalten oder die Bewegung der Bilder (`per_image`) als feste oder beobachtete Werte angeben.
        [none] Dort Punkte oder Passpunkte ergänzen oder die Bilder weglassen.
       *[other] Den Parameter festhalten.
     }

rank-share = Anteil { PERCENT($share) } %: { $kind ->
        [parameter] Parameter { $symbol } der Kamera { $name } { $image }
        [image] äußere Orientierung des Bildes { $name }
        [point] Punkt { $name }
        *[other] { $name }
    }
