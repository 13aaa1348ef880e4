report_surface-title = Oberfläche von { $name }

report_surface-subtitle = Dichte Punkte mit Standardabweichungen

report_surface-points = { $n } { $n ->
        [one] Punkt
        *[other] Punkte
    } aus { $maps } { $maps ->
        [one] Tiefenkarte
        *[other] Tiefenkarten
    }.

report_surface-median_sigma = Standardabweichung eines Punktes: { NUM($sigma, digits: 2) } { $unit ->
        [units] Einheiten
        *[other] { $unit }
    } (Median).

report_surface-no_scale = Der Maßstab ist willkürlich: Koordinaten und Standardabweichungen haben keine absolute Einheit.

report_surface-photographs_lost = { $n } { $n ->
        [one] Aufnahme
        *[other] Aufnahmen
    } der Ausgleichung { $n ->
        [one] war
        *[other] waren
    } nicht verwendbar.

report_surface-incomplete_maps = { $n } Tiefenkarten bedecken weniger als { PERCENT($share) } % der Aufnahme.

report_surface-incomplete_map = Die Tiefenkarte von { $name } bedeckt { PERCENT($share) } % der Aufnahme.

report_surface-excluded = { $n } { $n ->
        [one] Aufnahme oder Paar ist
        *[other] Aufnahmen oder Paare sind
    } ausgeschlossen.

report_surface-warnings = Warnungen und Abhilfe

report_surface-adjustment = Zugrunde liegende Ausgleichung

report_surface-files = Dateien

report_surface-contents = Inhalt

report_surface-file = { $file_name ->
        [points_ply] Punkte mit Farben und Standardabweichungen
        [points_las] Punkte für Programme, die LAS lesen
        [map_las] Punkte für Programme, die LAS lesen, im Koordinatensystem
        [heights_tif] Raster der Höhen
        [heights_sigma_tif] Standardabweichungen der Höhen, nach Anteilen
        [heights_toml] Lage und Einheit des Rasters, Einschränkungen der Verwendung
        [heights_orientation_npz] Einfluss der Orientierung auf die Höhen, für Summen und Differenzen
        [orthophoto_tif] wahres Orthofoto
        [orthophoto_sigma_tif] Standardabweichung der Lage seiner Pixel
        [orthophoto_toml] Lage des Orthofotos, verwendete Aufnahmen
        [mesh_ply] Dreiecksnetz mit Standardabweichungen
        [mesh_obj] Dreiecksnetz mit dem Orthofoto, für Modellierprogramme
        [mesh_glb] dasselbe in einer Datei, für Browser
        [depths] Tiefenkarten der Aufnahmen
        *[surface_3d_html] Punkte und Netz in drei Dimensionen
    }

report_surface-earlier_points = Punkte eines früheren Laufs, { $thinned ->
        [yes] ausgedünnt mit { $length }
        *[no] nicht ausgedünnt
    }

report_surface-sigma_of_point = Standardabweichung eines Punktes

report_surface-of_position = Median der Wurzel der Quadratsumme: X { NUM($x, digits: 2) }; Y { NUM($y, digits: 2) }; Z { NUM($z, digits: 2) } { $unit ->
        [units] Einheiten
        *[other] { $unit }
    }
    .why = Im Datum des Ergebnisses.

report_surface-sigma_along_ray = Standardabweichung längs des Strahls

report_surface-quantiles = Median; 90 % unter { NUM($sigma_90, digits: 2) }, 99 % unter { NUM($sigma_99, digits: 2) } { $unit ->
        [units] Einheiten
        *[other] { $unit }
    }

report_surface-photographs_per_point = Aufnahmen je Punkt

report_surface-by_two = Mittel; { PERCENT($share) } % aus zweien

report_surface-grazing = streifende Strahlen

report_surface-grazing_limit = Punkte unter weniger als 17 Grad zur Oberfläche

report_surface-excluded_name = ausgeschlossen

report_surface-excluded_caption = Ausgeschlossene Aufnahmen und Paare

report_surface-of_maps = aus { $n } { $n ->
        [one] Tiefenkarte
        *[other] Tiefenkarten
    }

report_surface-thinned_maps = aus { $n } { $n ->
        [one] Tiefenkarte
        *[other] Tiefenkarten
    }; ausgedünnt aus { $of }

report_surface-heights = Höhen

report_surface-heights_shown = Höhen { $of ->
        [map] im Koordinatensystem
        [plane] über der Ebene
        *[free] über der Ebene, ohne Einheit
    }; { PERCENT($share) } % der Zellen haben eine Höhe.

report_surface-heights_drawing = Höhen { $of ->
        [map] im Koordinatensystem
        [plane] über der Ebene
        *[free] über der Ebene, ohne Einheit
    }

report_surface-unmeasured_grey = Grau: nicht gemessen.

report_surface-sigma_of_height = Standardabweichung einer Höhe

report_surface-sigma_of_heights = Standardabweichungen der Höhen

report_surface-total_sigma = Standardabweichungen der Höhen, alle Anteile zusammen.

report_surface-profile = Profil durch die Mitte der Höhen, mit dem Band von 1,96 Standardabweichungen.

report_surface-orthophoto = Orthofoto

report_surface-orthophoto_shown = Wahres Orthofoto; Aufnahmen bedecken { PERCENT($share) } % seiner Pixel. Grau: nicht bedeckt.

report_surface-orthophoto_sigma = Standardabweichung einer Lage im Grundriss: { NUM($sigma, digits: 2) } { $unit ->
        [units] Einheiten
        *[other] { $unit }
    } (Median).

report_surface-sources = Partner

report_surface-points_given = verwendete Punkte

report_surface-depth_maps = Tiefenkarten

report_surface-measured_share = gemessen: Anteil der Pixel mit einer Tiefe{ $of_part ->
        [yes] {""}, um den gewählten Bereich
        *[no] {""}
    }.
    .why = { $of_part ->
            [yes] {""}
            *[no] Himmel und Stellen in nur einer Aufnahme haben keine.
        }

report_surface-map_sigma = Standardabweichung: längs des Strahls, Median.

report_surface-best_map = Von einem Punkt in mehreren Karten wird die genaueste Tiefe verwendet.

report_surface-map_measured = { PERCENT($share) } % gemessen

report_surface-standard_deviations = Standardabweichungen

report_surface-correlation = Angegebene Korrelation der Fehler zweier Punkte nach ihrem Abstand in der Aufnahme.
    .why = Sie gilt für Rauschen und Rauheit; Fehler von Orientierung und Kalibrierung reichen über das ganze Objekt.

report_surface-components = Rauschen: Streuung der Grauwerte, in diesen Aufnahmen gemessen.

report_surface-roughness_meaning = Rauheit: Änderung der Oberfläche im Fenster von 7 x 7 Pixeln.

report_surface-orientation_meaning = Orientierung: äußere und innere Orientierung, aus ihrer gemeinsamen Kovarianz.

report_surface-mean_of_points = Die Orientierung begrenzt die Präzision von Mitteln über viele Punkte. Summen von Höhen enthalten sie.

report_surface-common_errors = Nicht enthalten: gemeinsame Fehler aller Aufnahmen, etwa durch Spiegelungen, Wasser, Glas und wandernde Schatten.

report_surface-component = { $part ->
        [noise] Rauschen der Grauwerte
        [roughness] Rauheit
        [orientation] Orientierung und Kalibrierung
        *[total] gesamt
    }

report_surface-component_column = Anteil

report_surface-below = { $share } % unter

report_surface-components_caption = Anteile der Standardabweichungen längs des Strahls

report_surface-result = Ergebnis
