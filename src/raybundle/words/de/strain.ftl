strain-displacements = { $name }: { $n } von { $of } Subsets verfolgt, Standardabweichung { NUM($sigma_px, digits: 2) } px.

strain-motion = Gemeinsame Bewegung { NUM($u_px, digits: 4) } px nach rechts, { NUM($v_px, digits: 4) } px nach unten, { NUM($rotation_deg, digits: 3) } Grad.

strain-strains = Dehnung im Median [1e-6]: xx { NUM($xx, digits: 3) }, yy { NUM($yy, digits: 3) }, xy { NUM($xy, digits: 3) }, je ± { NUM($sigma, digits: 2) }; 99 % unter { NUM($largest, digits: 3) }.

strain-not_followed = { $name }{ $images ->
        [one] {""}
        *[other] , das schlechteste von { $images } Bildern
    }: { $n } von { $of } Subsets nicht verfolgt ({ LIST($states, most: 7) }).
    .why = outside: verlässt das Bild. flat: ohne Textur. unsteady: konvergiert nicht. unlike: Korrelation unter 0.75. torn: Teile bewegen sich auseinander. changed: Grauwerte verändert. unreached: kein Nachbar verfolgt.
    .do = Die Spalte state in displacements.csv mit den Bildern vergleichen.

strain-bent = { $name }: { PERCENT($share) } % der Subsets verformen sich stärker als affin ({ $limit_px } px).
    .why = Teile dieser Subsets sind gegen ihre Form verschoben. Die Standardabweichungen enthalten das nicht.
    .do = { OPTION("shape", "quadratic") } oder ein kleineres { OPTION("window", "PX") } verwenden.

strain-no_strain = { LIST($names, most: 3) }: keine Dehnung, weil nirgends { $gauge } x { $gauge } Subsets zur Hälfte verfolgt und verbunden sind.
    .do = Kleineres { OPTION("step", "PX") } oder { OPTION("gauge", "COUNT") } verwenden.

strain-no_subset = In die Probe passt kein Subset von { $window } x { $window } Pixeln.
    .do = Kleineres { OPTION("window", "PX") }, anderen Ausschnitt oder andere Maske angeben.

strain-nothing_followed = Keines von { $n } Subsets ist in { LIST($names, most: 3) } wiederzufinden.
    .why = Die Bilder haben keine gemeinsame Textur oder unterscheiden sich zu sehr in Licht oder Schärfe.
    .do = Prüfen, ob das Referenzbild zur Serie gehört.

strain-other_size = { $width_px } x { $height_px } Pixel, aber { $reference } hat { $reference_width_px } x { $reference_height_px }.
    .do = Bilder einer Kamera angeben, nicht beschnitten oder skaliert.

strain-same_image = Das Bild ist eine Kopie des Referenzbildes { $reference }.
    .why = Sein Rauschen ist dasselbe; Standardabweichungen wären falsch.
    .do = Ein anderes Bild angeben.

strain-empty_extent = Der Ausschnitt { LIST($extent) } enthält kein Pixel.
    .do = Links, oben, rechts, unten in dieser Reihenfolge angeben.

strain-map_empty = keine Werte

strain-repeated = { $name }: Die Textur wiederholt sich nach { NUM($period_px, digits: 3) } px (Korrelation { NUM($correlation, digits: 2) }).
    .why = Eine Verschiebung um eine ganze Periode sieht aus wie keine; Fenster können eine Periode daneben gefunden werden.
    .do = Ein zufälliges Muster verwenden, oder { OPTION("window", "PX") } über mehrere Perioden mit etwas, das sich nicht wiederholt.

strain-saturated = { $name }: { PERCENT($share) } % der Pixel haben den dunkelsten oder hellsten Grauwert (Grenze { PERCENT($limit) } %).
    .why = Sie tragen weder Ort noch Rauschen: Standardabweichungen sind zu klein, bei einem Drittel der Pixel um ein Fünftel.
    .do = So belichten, dass kein Pixel gesättigt ist.

strain-mask_empty = Die Maske { $name } maskiert nichts.
    .why = Nur Pixel mit dem Grauwert 0 sind maskiert; Transparenz wird nicht gelesen.
    .do = Ein Bild angeben, das außerhalb der Probe schwarz ist.

strain-pages = Von Dateien mit mehreren Bildern wird nur das erste verwendet: { LIST($names, most: 3) }.
    .do = Jedes Bild als eigene Datei speichern.

strain-jumps = { $name }: Verschiebungen springen zwischen { $n } von { $of } Nachbarpaaren.
    .why = Die Form eines Fensters sagt voraus, wo sein Nachbar liegt; { PERCENT($share) } % liegen mehr als ein Pixel daneben. Die Textur wiederholt sich, oder die Bewegung ist zu groß.
    .do = Dieses Bild nicht verwenden. Zufälliges Muster, größeres { OPTION("window", "PX") } oder Bilder bei kleineren Lasten dazwischen.

strain-same_content = Die Referenz selbst, verschoben oder nicht: { LIST($names, most: 3) }.
    .why = Ihr Rauschen ist dasselbe; Standardabweichungen sind zu klein.
    .do = Ein anderes Bild angeben.

strain-image_twice = Das Bild ist zweimal angegeben.
    .do = Jedes Bild einmal angeben.

strain-area = Bereich { $name } ({ $n } Subsets), Dehnung [1e-6]: xx { NUM($xx, digits: 3) } ± { NUM($s_xx, digits: 2) }, yy { NUM($yy, digits: 3) } ± { NUM($s_yy, digits: 2) }, xy { NUM($xy, digits: 3) } ± { NUM($s_xy, digits: 2) }.

strain-area_text = { $text } ist kein Bereich.
    .do = NAME:LINKS,OBEN,RECHTS,UNTEN in Pixeln angeben, jeden Namen einmal.

strain-area_not_one = Bereich { $name } ({ $n } Subsets) hat nicht eine Dehnung; Ebene [1e-6]: xx { NUM($xx, digits: 2) }, yy { NUM($yy, digits: 2) }, xy { NUM($xy, digits: 2) }.
    .why = Die Verschiebungen weichen um { NUM($misfit, digits: 2) } Standardabweichungen (rms) von dieser Ebene ab. Eine Standardabweichung wird nicht angegeben.

strain-area_uneven = Die Dehnung ist in { $n } { $n ->
        [one] Bereich
       *[other] Bereichen
    } nicht überall gleich, am wenigsten in { $area } ({ $name }).
    .why = Die Verschiebungen weichen um { NUM($misfit, digits: 2) } Standardabweichungen (rms) von einer Ebene ab. Dehnung und Standardabweichung sind die der Ebene.
    .do = Kleinere Bereiche wählen oder die Karten verwenden.

strain-area_empty = Der Bereich { $area } hat in { LIST($names, most: 3) } zu wenige Subsets.
    .do = Einen größeren Bereich oder kleineres { OPTION("step", "PX") } wählen.

strain-area_outside = Der Bereich { $area } liegt nicht im Bild von { $width_px } x { $height_px } px.
    .do = Links, oben, rechts und unten in Pixeln des Referenzbildes angeben.
