mark-exists = Punkt { $point } ist in Bild { $image } schon gemessen.
    .do = Die Bildmessung verschieben oder zuerst entfernen.

mark-name_taken = Punkt { $point } lässt sich nicht in { $to } umbenennen: Der Name ist vergeben.
    .do = Einen anderen Namen wählen oder den anderen Punkt zuerst löschen.

mark-point_of_block = Punkt { $point } stammt aus dem Block; keine Bildmessung ist von Hand gemacht.
    .do = Seine Bildbeobachtungen einzeln verwerfen.

mark-bar_same_ends = Maßstabsstrecke { $start } - { $end }: Beide Enden sind derselbe Punkt.
    .do = Zwei verschiedene Punkte angeben.

mark-bar_sigma = Maßstabsstrecke { $start } - { $end }: Die Standardabweichung { $sigma } ist zu groß für eine Länge von { $length }.
    .why = Die Standardabweichung darf höchstens die Länge geteilt durch { $ratio } sein.
    .do = Die Länge oder ihre Standardabweichung korrigieren.

mark-no_bar = Es gibt keine Maßstabsstrecke { $start } - { $end }.
    .why = Gemessen sind: { $known }.
    .do = Die Enden einer gemessenen Maßstabsstrecke angeben.

mark-no_line = Es gibt keine Linie { $line_name }.
    .why = Linien sind: { $known }.
    .do = Den Namen korrigieren.

mark-line_points = Linie { $line_name } (Art { $kind }) hat { $n } verschiedene Punkte; nötig sind { $least }.
    .do = Mehr Punkte angeben, jeden einmal.

mark-no_observation = Der Block hat keine Beobachtung des Punkts { $point } in Bild { $image }.
    .do = Eine von Hand gemachte Bildmessung entfernen; verworfen werden nur Beobachtungen des Blocks.

mark-not_rejected = Punkt { $point } in Bild { $image } ist nicht von Hand verworfen.
    .do = Eine von Hand verworfene Beobachtung wählen.

mark-bad_name = { $kind ->
        [line] Linie
        [drawing] Zeichnung
        [layer] Layer
        [note] Notiz
        [mask] Maske
        [table] Tabelle
       *[point] Punkt
     } { $name } hat einen ungültigen Namen ({ $n } Zeichen).
    .why = Ein Name hat 1 bis { $most } druckbare Zeichen und kein Leerzeichen am Anfang oder Ende.
    .do = Einen anderen Namen wählen.

mark-sigma_without_coordinate = Punkt { $point } hat eine Standardabweichung von { $axis }, aber kein { $axis }.
    .do = Die Koordinate angeben.

mark-role_without_coordinate = Punkt { $point } ist ein { $role ->
        [check] Kontrollpunkt
       *[control] Passpunkt
     } ohne Koordinaten.
    .do = Mindestens eine Koordinate angeben oder ihn zum Verknüpfungspunkt machen.

mark-control_without_sigma = Passpunkt { $point }: { $axis } hat keine Standardabweichung.
    .do = Eine angeben; 0 hält die Koordinate fest.

mark-unknown_point = Punkt { $point } ist weder gemessen noch im Block.
    .why = { $n ->
        [0] Kein Punkt ist gemessen.
       *[other] Gemessen sind: { $known }.
     }
    .do = Den Punkt zuerst in einem Bild messen oder seinen Namen korrigieren.

mark-not_marked = Punkt { $point } ist in Bild { $image } nicht von Hand gemessen.
    .why = { $n ->
        [0] Er ist in keinem Bild gemessen.
       *[other] Er ist gemessen in: { $images_marked }.
     }
    .do = Ein Bild wählen, in dem er gemessen ist.

mark-covariance = Bild { $image }: Eine Kovarianz von { $xy_px2 } px² ist mit Varianzen von { $xx_px2 } und { $yy_px2 } px² unmöglich.
    .why = Der Betrag der Kovarianz muss kleiner sein als die Wurzel aus deren Produkt.
    .do = Die Kovarianz korrigieren.

mark-unknown_image = Bild { $image } ist keines der { $n } Bilder.
    .why = Es sind { $known }.
    .do = Den Namen korrigieren.

mark-outside_image = Bild { $image }: x = { NUM($x_px, digits: 6) }, y = { NUM($y_px, digits: 6) } liegt außerhalb der { $width_px } x { $height_px } px.
    .why = Pixel zählen von der linken oberen Ecke der gespeicherten Datei nach rechts und unten.
    .do = Die Stelle korrigieren.

mark-mask_corners = Maske { $mask } hat { $n } Ecken; möglich sind 3 bis { $most }.
    .do = Das Polygon neu zeichnen.

mark-mask_area = Maske { $mask }: Die Ecken umschließen { NUM($area_px2, digits: 2) } px², weniger als { $least_px2 } px².
    .do = Ecken angeben, die nicht auf einer Geraden liegen.

mark-no_mask = Es gibt keine Maske { $mask }.
    .why = { $n ->
        [0] Keine Maske ist gezeichnet.
       *[other] Masken sind: { $known }.
     }
    .do = Den Namen korrigieren.

mark-drawing_corners = { $drawing } hat { $n } Ecken; möglich sind { $least } bis { $most }.
    .do = Neu zeichnen.

mark-drawing_surface = { $drawing }: { $surface } ist kein Ordner im Projekt.
    .do = Den Namen eines Oberflächenordners angeben, etwa surface.

mark-no_drawing = Es gibt keine Zeichnung { $drawing }.
    .why = { $n ->
        [0] Nichts ist gezeichnet.
       *[other] Zeichnungen sind: { $known }.
     }
    .do = Einen dieser Namen verwenden.

mark-no_masks_at_all = Keine Maske ist gezeichnet oder aus einem Ordner gelesen.
    .do = Eine im Studio oder mit raybundle mark mask zeichnen.

mark-image_not_in_block = Punkt { $point } ist in Bild { $image } gemessen, das nicht im Block ist.
    .why = Er wurde in anderen Aufnahmen gemessen.
    .do = Die Bildmessung entfernen.

mark-control_far_away = Passpunkt { $point } ist { $distance } { $unit } von den anderen entfernt, das { $ratio }-fache ihrer Ausdehnung.
    .why = Die Grenze ist das { $limit }-fache.
    .do = Dezimalzeichen und Einheit seiner Koordinaten prüfen.

mark-outside_photograph = { NUM($x_px, digits: 6) }, { NUM($y_px, digits: 6) } liegt außerhalb der Aufnahme { $image } ({ $width_px } x { $height_px } px).
    .do = In der Aufnahme in voller Größe messen{ $turned ->
     [yes] { "" }, und so, wie sie gespeichert ist (Bildbetrachter drehen sie nach ihrer EXIF-Orientierung { $orientation })
     *[no] { "" }
    }.

mark-not_in_result = Punkt { $point } ist von Hand gemessen, aber nicht in diesem Ergebnis.
    .do = { $adjusted ->
        [yes] { $folder } verwenden, das Ergebnis mit den gemessenen Punkten
       *[no] Den Punkt zuerst mit dem Block ausgleichen: raybundle mark adjust
     }.

mark-nothing_to_reject = Weder ein Bildpunkt noch eine Grenze ist angegeben.
    .do = Ein Bild und einen Punkt oder eines von { LIST($limits, most: 9) } angeben.

mark-contradicts = { $n ->
        [one] Die Bildmessung von { $point } in { $images } widerspricht den anderen{ $size_px ->
            [0] {""}
           *[other] {" "}um { NUM($size_px, digits: 2) } px
        }
       *[other] Die Bildmessungen von { $point } widersprechen sich: { $images }
    }{ $tau ->
        [0] .
       *[other] {" "}(Testgröße { NUM($tau, decimals: 1) }).
    }
    .do = Die Bildmessung prüfen.

mark-off = Die Bildmessung von { $point } in { $image } liegt { NUM($distance_px, digits: 2) } px ({ NUM($sigmas, digits: 2) } Standardabweichungen) daneben.
    .why = { $n ->
        [one] Die andere Beobachtung sieht
       *[other] Die { $n } anderen Beobachtungen sehen
    } den Punkt an anderer Stelle. Grenze: vier Standardabweichungen.
    .do = Die Bildmessung in { LIST($images, most: 4) } prüfen, die erste zuerst.

mark-fits = { $point } passt: { NUM($distance_px, digits: 2) } px ({ NUM($sigmas, digits: 2) } Standardabweichungen) neben den anderen.

mark-open = { $point } ist noch nicht geprüft: { NUM($distance_px, digits: 2) } px neben den anderen, größere Fehler sind möglich.
    .do = In einem weiteren Foto aus anderer Richtung messen.

mark-tested_later = Die Bildmessung von { $point } in { $image } ist noch nicht geprüft.
    .why = Der Block hat { $n } Bildbeobachtungen; sofort geprüft wird bis { $most }.
    .do = `raybundle mark adjust` prüft alle Bildmessungen.

mark-control_names = { $n } Passpunkte passen nicht zu ihren Bildmessungen: nach einem gemeinsamen Versatz fehlen { NUM($missed, digits: 2) } { $unit }.
    .why = Das ist der Median; die Fotos lassen { NUM($limit, digits: 2) } { $unit } zu.{ $exchanged ->
        [0] { "" }
       *[other] { " " }Mit anderen Namen passen sie:
    }
    .do = Namen, Einheit und Reihenfolge der Koordinaten in der Passpunkttabelle prüfen.

mark-control_named = Die Koordinaten von { $point } sind die der Bildmessungen von { $at }.

mark-control_apart = Der nächste Passpunkt { $point } liegt { NUM($distance, digits: 3) } { $unit } von den Fotos entfernt.
    .why = Die Fotos und was sie zeigen, reichen über { NUM($extent, digits: 2) } { $unit }; erlaubt sind { NUM($limit, digits: 2) } { $unit }.
    .do = Koordinatensystem{ $crs ->
        [none] { "" }
       *[other] { "" } (das Projekt hat { $crs })
    }, Einheit und Reihenfolge der Koordinaten prüfen.

mark-control_unmarked = { $n } von { $of } Passpunkten sind in keiner Aufnahme markiert: { LIST($points, most: 8) }.
    .do = Unter diesen Namen markieren, oder die Namen prüfen.
