control_contradicts-scattered = Die Passpunkte aus { $name } passen nicht: Nur { $agree } von { $n } stimmen überein, auf { NUM($rms_mm, digits: 2) } mm (rms).
    .why = Kein Passpunkt geht in die Ausgleichung ein; die Achsen sind nicht die der Passpunkte.
    .do = Namen und Koordinaten der Datei prüfen.

control_contradicts-scale = Die Passpunkte aus { $name } und die Maßstabsstrecken unterscheiden sich im Maßstab um { $near_1 ->
        [yes] { NUM($scale_ppm, digits: 4) } ppm
       *[no] einen Faktor von { NUM($factor, digits: 6) }
     }.
    .why = Kein Passpunkt geht in die Ausgleichung ein; den Maßstab bestimmen die Maßstabsstrecken ({ NUM($rms_same_scale_mm, digits: 2) } mm rms ohne den Faktor).
    .do = Die Einheit der Datei und die Längen der Maßstabsstrecken prüfen.

control_contradicts-ambiguous = { $n } Passpunkte aus { $name } widersprechen den übrigen; welche falsch sind, ist nicht eindeutig.
    .why = Alle Passpunkte gehen in die Ausgleichung ein; eine falsche Koordinate verformt das Ergebnis.
    .do = Koordinaten und Namen von { $ids } prüfen oder Passpunkte ergänzen.

control_contradicts-rejected = { $points } von { $control } Passpunkten: mehr als { PERCENT($limit) } % ihrer Bildpunkte sind verworfen: { $ids }.
    .why = Die Passpunkte widersprechen den Aufnahmen, oder ihre Namen sind vertauscht.
    .do = Koordinaten, Koordinatensystem, Reihenfolge und Vorzeichen der Achsen, Einheit und Namen prüfen.

control_contradicts-mirrored = Die Passpunkte sind ein Spiegelbild des Objekts: Gespiegelt ist sigma0 { $mended } (Grenze { $limit }).
    .why = { $solved ->
     [yes] Mit den Passpunkten wie angegeben ist sigma0 { $sigma0 }.
     *[no] Mit den Passpunkten wie angegeben hat der Block keine Lösung.
    }
    .do = { $cause ->
     [images] observations.csv korrigieren: x zählt nach rechts, y nach unten. Ursache:
     [open] Die Passpunktdatei oder observations.csv korrigieren. Mögliche Ursachen:
     *[control] Die Passpunktdatei korrigieren. Mögliche Ursachen:
    }

control_contradicts-mend = { $mend ->
     [xy] X und Y der Passpunkte sind vertauscht
     [yz] Y und Z der Passpunkte sind vertauscht
     [xz] X und Z der Passpunkte sind vertauscht
     [x] X der Passpunkte hat das falsche Vorzeichen
     [y] Y der Passpunkte hat das falsche Vorzeichen
     *[z] Z der Passpunkte hat das falsche Vorzeichen
    }

control_contradicts-exchanged = Passpunkte { $names } sind wohl vertauscht: Mit vertauschten Koordinaten ist sigma0 { $mended } (Grenze { $limit }).
    .why = { $solved ->
     [yes] Wie angegeben ist sigma0 { $sigma0 }.
     *[no] Wie angegeben hat der Block keine Lösung.
    }
    .do = Die Koordinaten dieser Passpunkte in der Datei oder ihre Namen in den Bildern vertauschen.

control_contradicts-points = { $n ->
     [one] Passpunkt { $names } widerspricht
     *[other] Passpunkte { $names } widersprechen
    } den Aufnahmen und den anderen Passpunkten.
    .why = Ohne { $n ->
     [one] ihn
     *[other] sie
    } ist sigma0 { $mended } (Grenze { $limit }); { $solved ->
     [yes] mit allen Passpunkten { $sigma0 }
     *[no] mit allen Passpunkten hat der Block keine Lösung
    }.
    .do = Koordinaten und Namen in den Bildern prüfen oder falsche Punkte weglassen.

control_contradicts-centres = Passpunkte und beobachtete Projektionszentren widersprechen einander.
    .why = sigma0 ist { $centres } mit den Zentren allein und { $control } mit den Passpunkten allein (Grenze { $limit }); { $solved ->
     [yes] mit beiden { $sigma0 }
     *[no] mit beiden hat der Block keine Lösung
    }.
    .do = Höhenbezug, Koordinatensystem, Achsen und Antennenversatz prüfen oder eines von beiden weglassen. Unterschiede:

control_contradicts-axis = Koordinate { $axis }: Projektionszentren minus Passpunkte sind { $apart } (± { NUM($sigma, digits: 2) }).

control_contradicts-one_of_few = Einer der Passpunkte { $names } ist falsch; welcher, ist nicht eindeutig.
    .why = Ohne Passpunkte ist sigma0 { $alone } (Grenze { $limit }); { $solved ->
     [yes] mit ihnen { $sigma0 }
     *[no] mit ihnen hat der Block keine Lösung
    }.
    .do = Koordinaten, Namen und Achsen prüfen oder mehr Passpunkte messen.

control_contradicts-unexplained = Die { $n } Passpunkte passen nicht zu den Aufnahmen; kein einzelner Punkt erklärt es.
    .why = Ohne Passpunkte ist sigma0 { $alone } (Grenze { $limit }); { $solved ->
     [yes] mit ihnen { $sigma0 }
     *[no] mit ihnen hat der Block keine Lösung
    }: { LIST($names, most: 10) }.
    .do = Einheit, Koordinatensystem, Achsen, Namen und Koordinaten der Passpunkte prüfen.
