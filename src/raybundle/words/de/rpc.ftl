rpc-not_of_rasterio = Ein Objekt vom Typ { $kind } ist kein RPC von rasterio ({ $detail }).
    .do = dataset.rpcs angeben.

rpc-wrong_shape = RPC: { $name } hat die Dimension ({ $shape }) oder Werte, die nicht endlich sind.
    .do = Endliche Zahlen der Dimension ({ $needed }) angeben.

rpc-not_positive = RPC: { $name } ist { $values }.
    .do = Werte über 0 angeben.

rpc-centre_out_of_range = RPC: Geographische Breite { $latitude_deg }°, Länge { $longitude_deg }° der Mitte sind nicht gültig.
    .why = Die Grenzen sind 90° und 360°.
    .do = Prüfen, ob beide vertauscht sind.

rpc-zero_denominator = RPC: Der Nenner der { $axis ->
        [line] Zeile
       *[sample] Spalte
     } ist in der Mitte der Szene null.
    .do = Die Datei neu beschaffen; sie ist beschädigt.

rpc-no_ground_point = Der Bildpunkt Zeile { NUM($image_line, decimals: 2) }, Spalte { NUM($sample, decimals: 2) } hat keinen Geländepunkt in der Höhe { $height_m } m.
    .why = { $others ->
        [0] Das RPC gilt für Höhen von { $low_m } bis { $high_m } m.
       *[other] Das RPC gilt für Höhen von { $low_m } bis { $high_m } m. { $others } weitere Punkte von { $n } haben auch keinen.
     }
    .do = Eine Höhe in diesem Bereich angeben.

rpc-points_far_away = { $n } von { $total } Punkten liegen weit außerhalb der Szene; Punkt { $point } um das { NUM($ratio, digits: 4) }-fache ihrer Ausdehnung.
    .why = { $point } liegt bei { NUM($longitude_deg, decimals: 6) }°, { NUM($latitude_deg, decimals: 6) }°, die Mitte bei { NUM($centre_longitude_deg, decimals: 6) }°, { NUM($centre_latitude_deg, decimals: 6) }° (Grenze { $limit } Ausdehnungen).
    .do = { $exchanged ->
        [yes] Geographische Länge und Breite tauschen, in den Punkten oder im RPC
       *[no] Prüfen, ob Punkte und Szene zusammengehören, sowie Folge und Einheiten der Spalten
     }.

rpc-small_denominator = RPC: Der Nenner der { $axis ->
        [line] Zeile
       *[sample] Spalte
     } ist { NUM($ratio, digits: 2) } seines Werts in der Mitte (Grenze { $limit }).
    .why = Der Punkt liegt bei { NUM($longitude_deg, decimals: 6) }°, { NUM($latitude_deg, decimals: 6) }°, { NUM($height_m, decimals: 1) } m; das RPC gilt von { $low_m } bis { $high_m } m.
    .do = Prüfen, ob der Punkt in der Szene liegt, oder das RPC neu beschaffen.

rpc-point_shape = Die Punkte haben die Dimension ({ $shape }).
    .do = Ein Feld der Dimension (n, 3) angeben: geographische Länge, Breite, Höhe.

rpc-height_range = Der Höhenbereich ist { $low_m } bis { $high_m } m.
    .do = Einen Bereich von mindestens 1 m angeben.

rpc-no_fit = Kein RPC ohne Nullstelle in einem Nenner passt zu diesem Modell.
    .why = Der Höhenbereich oder das Bild ist zu groß für ein RPC.
    .do = Einen kleineren Höhenbereich oder einen Teil des Bildes angeben.

rpc-inaccurate_fit = Das beste RPC weicht um { $misfit_px } px von diesem Modell ab (Grenze { $limit_px } px).
    .why = { $polar ->
        [yes] Die Szene reicht bis zur geographischen Breite { NUM($latitude_deg, decimals: 3) }°, nahe an einen Pol, wo geographische Längen mehrdeutig sind.
       *[no] Das Bild oder der Höhenbereich ist zu groß, oder das Modell ist nicht glatt.
     }
    .do = Das strenge Modell oder einen Teil des Bildes verwenden.

rpc-scene_localisation = Szene { $scene }: Ein Bildpunkt hat keinen Geländepunkt.
    .why = Die RPC gelten an diesem Bildpunkt oder in dieser Höhe nicht.
    .do = Bildkoordinaten und Höhe prüfen oder die RPC neu beschaffen.

rpc-corrected = RPC { $kind ->
        [none] nicht korrigiert
        [shift] um Verschiebung korrigiert
        [drift] um Drift korrigiert
        *[other] affin korrigiert
    }: Verbesserungen { NUM($x_px, digits: 2) }, { NUM($y_px, digits: 2) } px (RMS, { $n } { $n ->
        [one] Passpunkt
        *[other] Passpunkte
    }).

rpc-check_points = { $n } { $n ->
        [one] Kontrollpunkt
        *[other] Kontrollpunkte
    }: { NUM($rms_m, digits: 2) } m am Boden ({ NUM($x_px, digits: 2) }, { NUM($y_px, digits: 2) } px RMS).

rpc-ground_errors = Genauigkeit am Boden (68 %, je Achse): ERR_BIAS { NUM($bias_m, digits: 2) } m, ERR_RAND { $rand_known ->
        [yes] { NUM($rand_m, digits: 2) } m
        *[no] unbekannt
    }.

rpc-points_contradict = { $n } von { $of } Passpunkten widersprechen den anderen: { $names } (bis { NUM($largest_px, digits: 2) } px).
    .why = Diese Passpunkte werden nicht verwendet.
    .do = Koordinaten, Höhen und Bildmessungen prüfen.

rpc-points_outside = { $n } { $n ->
        [one] Passpunkt liegt
        *[other] Passpunkte liegen
    } außerhalb des Bildes oder der Höhen des RPC: { $names }.
    .why = Das RPC gilt dort nicht.
    .do = Höhen und Bildkoordinaten prüfen.

rpc-shift_large = Die Verschiebung ist das { NUM($ratio, digits: 2) }-fache des vom Anbieter angegebenen Fehlers.
    .why = Passpunkte oder RPC gehören vielleicht zu einer anderen Szene oder einem anderen Datum.
    .do = Koordinatensystem und Höhenbezug der Passpunkte prüfen.

rpc-residuals_large = Die Verbesserungen sind das { NUM($ratio, digits: 2) }-fache des angegebenen Sigma von { $sigma_px } px.
    .why = Die Standardabweichungen sind um diesen Faktor vergrößert.
    .do = Angegebenes Sigma und Messungen prüfen.

rpc-no_redundancy = { $n } { $n ->
        [one] Passpunkt lässt
        *[other] Passpunkte lassen
    } keine Redundanz.
    .why = Ein falscher Punkt bleibt unentdeckt.
    .do = Einen weiteren Passpunkt messen.

rpc-error_sources = 1 m Höhenfehler verschiebt einen Punkt um { NUM($east, digits: 2) } m nach Osten, { NUM($north, digits: 2) } m nach Norden.
    .why = Höhen der Passpunkte tragen { NUM($height_m, digits: 2) } m zu ERR_BIAS bei; ERR_RAND ist { $by_points ->
            [yes] die Streuung der Punkte
            *[no] vom Anbieter angegeben
        }.

rpc-refitted = Neu angepasstes RPC: höchstens { NUM($largest_px, digits: 2) } px vom korrigierten.

rpc-other_image = Das RPC gehört nicht zu diesem Bild von { $width_px } x { $height_px } px.
    .why = Das RPC umfasst die Spalten { $first_column } bis { $last_column } und die Zeilen { $first_row } bis { $last_row }.
    .do = Das RPC dieses Bildes angeben; für ein verkleinertes oder beschnittenes Bild Verschiebungen und Skalierungen anpassen.

rpc-projection_not_finite = RPC: Seine Abbildung ist innerhalb der Szene nicht endlich.
    .do = Die Datei neu beschaffen; sie ist beschädigt.

rpc-keys_missing = Das RPC ist unvollständig; es fehlt: { LIST($names, most: 10) }.
    .do = Die vollständige Datei beschaffen.

rpc-coefficient_count = Das RPC ist unvollständig: { $name } hat { $n } von 20 Koeffizienten.
    .do = Die vollständige Datei in der Form RPC00B beschaffen.

rpc-metadata_below = Metadaten des Bereichs RPC stehen in einem tieferen Element, nicht in der Wurzel.
    .do = Die Datei des Rasters angeben, das das RPC hat.

rpc-not_one = Die Datei enthält { $n } RPC{ $n ->
     [0] { "" }
     *[other] { " " }({ $names })
    }; genau eines ist nötig.
    .do = Eine Datei mit einem Bild angeben.

rpc-two_values = Dieser Schlüssel ist hier { $value } und in Zeile { $other_line } { $other }.
    .do = Einen der beiden löschen.

rpc-unit = Die Einheit ist { $unit }; das RPC braucht { $needed }.
    .do = Das RPC umrechnen.

rpc-no_tag = Die TIFF-Datei enthält kein RPC (Tag 50844).
    .do = Die Datei mit dem RPC angeben (_RPC.TXT, .RPB, .XML).

rpc-tag_count = Das RPC-Tag hat { $n } Zahlen; 92 sind nötig.
    .do = Die Datei neu beschaffen; sie ist beschädigt.

rpc-not_finite = RPC: Eine Zahl ist nicht endlich.
    .do = Die Datei neu beschaffen; sie ist beschädigt.

rpc-geotiff_needs_picture = Ein GeoTIFF mit RPC braucht das Bild der Szene, das fehlt.
    .do = Das Raster als Szene angeben oder NAME_RPC.TXT, NAME.RPB oder NAME.geom schreiben.

rpc-file_precedes_tag = { $name } liegt im selben Ordner; GDAL würde ihr RPC statt des Tags lesen.
    .do = Die Datei verschieben oder einen anderen Namen wählen.

rpc-name_ending = { $ending ->
     [blank] Der Name hat keine Endung
     *[other] Die Endung { $ending } gehört zu keinem Format von RPC
    }.
    .do = NAME_RPC.TXT, NAME.RPB, NAME.geom wählen oder NAME.tif für das Bild mit seinem RPC.

rpc-tag_differs = Das von GDAL geschriebene Tag weicht vom RPC ab; keine Datei wird geschrieben.
    .do = NAME_RPC.TXT, NAME.RPB oder NAME.geom schreiben.

rpc-terms_reordered = Die Glieder des RPC00A wurden in die Reihenfolge von RPC00B gebracht.

rpc-specification_assumed = { $specification ->
     [none] Die Spezifikation des RPC fehlt
     *[other] Die Spezifikation des RPC ist { $specification }
    }; RPC00B wird angenommen.

rpc-point_far_away = Ein Punkt ist das { NUM($ratio, digits: 4) }-Fache des Bereichs der RPC von der Szenenmitte entfernt (Grenze { $limit }).
    .do = Folge und Einheiten der Koordinaten prüfen.

rpc-control_set_aside = Szene { $scene }: Punkte widersprechen den übrigen und werden nicht verwendet: { $points }.
    .do = Prüfen Sie ihre Koordinaten und Bildpunkte.

rpc-scene_left_out = Szene { $scene } ist nicht korrigiert.

rpc-points_beyond = Punkte außerhalb des Gültigkeitsbereichs des RPC: { $points }.
    .why = Dort kann ein RPC um viele Pixel falsch sein.

rpc-points_lost = Punkte ohne { $which ->
    [ground] Objektkoordinaten
    *[image] Bildkoordinaten
 }: { $points }.
    .why = Ihre Zellen sind leer; den Grund nennt die Spalte note.

rpc-bursts = Kein RPC passt zu einem Bild aus { $n } Bursts: Zeilen zwischen ihnen sind doppelt aufgenommen.
    .do = Die Szene selbst verwenden (model = "range_doppler") oder das Produkt in Bodenentfernung beschaffen.
