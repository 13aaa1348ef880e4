studio_point-current = Aktueller Punkt

studio_point-current_name = Name des aktuellen Punkts

studio_point-current_none = keiner (N: neuer Punkt)

studio_point-coordinates = Koordinaten des aktuellen Punkts

studio_point-marks = Bildmessungen des aktuellen Punkts

studio_point-filter = Punkte filtern

studio_point-points = Punkte

studio_point-points_of = Punkte: { $n } gemessen, { $of } im Bildverband

studio_point-visible = Sichtbar, nicht gemessen ({ $n })

studio_point-visible_images = Bilder, in denen der aktuelle Punkt sichtbar und nicht gemessen ist

studio_point-angle = Winkel zum nächsten gemessenen Strahl

studio_point-new = Neu
    .title = Neuer Punkt (N)

studio_point-snap = fangen an

studio_point-how = { $how ->
        [auto] auto
        [ellipse] Ellipse
        [corner] Ecke
        [cross] Kreuz
        [patch] Bildausschnitt
        [hand] von Hand
        *[file] Datei
    }

studio_point-snapping = Fangen an: { studio_point-how }

studio_point-worst_next = Schlechteste
    .title = Die nächste der schlechtesten Beobachtungen und Punkte zeigen (W)

studio_point-no_worst = Es gibt noch keine Ausgleichung.

studio_point-worst = { $number } von { $of }: { $point }, { $kind ->
        [w] |w| = { $value }
        [sigma] Sigma { $value } { $unit }
        *[rays] { $n } Strahlen
    }

studio_point-none_visible = Der aktuelle Punkt ist in keinem weiteren Bild sichtbar.

studio_point-no_unit = ohne Einheit

studio_point-choose_or_begin = Einen Punkt in einem Bild oder in der Liste anklicken oder einen neuen beginnen.

studio_point-located = { $source ->
        [adjusted] Aus der Ausgleichung
        [updated] Aus der Ausgleichung und späteren Bildmessungen
        [intersected] Aus seinen Bildmessungen geschnitten
        [ray] Einmal gesehen: Tiefe unbekannt
        *[unknown] Noch nicht gesehen
    }; { $n } { $n ->
        [one] Strahl
        *[other] Strahlen
    }.

studio_point-by = durch

studio_point-sigma_px = s
    .title = Standardabweichung [px]

studio_point-vx = vx
    .title = Verbesserung in x [px]

studio_point-vy = vy
    .title = Verbesserung in y [px]

studio_point-show = { $point } zeigen

studio_point-choose = { $point } wählen

studio_point-measure = { $name } messen

studio_point-remove = { $name } entfernen

studio_point-removed = Entfernt: { $name }.

studio_point-mark_count = { $n } { $n ->
        [one] Bildmessung
        *[other] Bildmessungen
    }

studio_point-mark_removed = Bildmessung von { $point } entfernt.

studio_point-marked = { $point } gemessen: { studio_point-how }, { $sigma_px } px{ $cause ->
        [none] {""}
        *[other] ; { $cause }
    }{ $far_px ->
        [0] {""}
        *[other] ; { $far_px } px vom Klick, bitte prüfen
    }.

studio_point-moved = { $point } verschoben: { studio_point-how }, { $sigma_px } px{ $cause ->
        [none] {""}
        *[other] ; { $cause }
    }{ $far_px ->
        [0] {""}
        *[other] ; { $far_px } px vom Klick, bitte prüfen
    }.

studio_point-marked_before = { $point } ist hier schon gemessen.
    .do = Die Bildmessung ziehen oder mit Umschalt und den Pfeiltasten verschieben.

studio_point-not_marked = Der aktuelle Punkt ist in diesem Bild nicht gemessen.

studio_point-none_chosen = Kein Punkt ist gewählt.
    .do = Mit N einen beginnen oder einen Bildpunkt anklicken.

studio_point-new_point = Neuer Punkt { $point }.
    .do = Ihn in einem Bild anklicken oder das Fadenkreuz dorthin bewegen und Eingabe drücken.

studio_point-rejected = { $point } wird ab der nächsten Ausgleichung nicht verwendet.

studio_point-accepted = { $point } wird ab der nächsten Ausgleichung wieder verwendet.

studio_point-patch_reference = Ein Bildausschnitt braucht seinen Punkt in einem anderen Bild; ihn dort zuerst messen.

studio_point-role = { $role ->
        [control] Passpunkt
        [check] Kontrollpunkt
        *[tie] Verknüpfung
    }

studio_point-role_given = { $point }: { studio_point-role }

studio_point-role_of_current = Rolle des aktuellen Punkts

studio_point-of_point = von { $point }

studio_point-number_missing = { $field }: Eine Zahl fehlt.

studio_point-give = Angeben

studio_point-bars = Maßstabsstrecken

studio_point-bar_start = von Punkt

studio_point-bar_start_as = von Punkt, z. B. { $point }

studio_point-bar_end = bis Punkt

studio_point-last_two = Die beiden zuletzt gemessenen Punkte verwenden

studio_point-bar_given = Maßstabsstrecke { $start } – { $end }: { $length }

studio_point-control = Pass- und Kontrollpunkte

studio_point-control_table = Tabelle mit Passpunktkoordinaten

studio_point-control_note = Eine Tabelle point,X,Y,Z,sX,sY,sZ irgendwo auf diesem Fenster ablegen.

studio_point-control_added = { $n } { $n ->
        [one] Passpunkt
        *[other] Passpunkte
    } aus { $name }

studio_point-table_too_large = { $name } ist zu groß für eine Tabelle mit Passpunktkoordinaten.

studio_point-drop = Die Tabelle mit Passpunktkoordinaten ablegen

studio_point-lines = Linien, Niveaus, Ebenen

studio_point-line_name = Name der Figur

studio_point-line_kind = { $kind ->
        [straight] Gerade
        [plumb] Lotlinie
        [level] Niveau
        *[plane] Ebene
    }

studio_point-line_kinds = Art der Figur

studio_point-line_points = Punkte der Linie

studio_point-line_sigma = Standardabweichung des Abstands eines Punkts davon

studio_point-line_given = { studio_point-line_kind } { $line }: { $points }

studio_point-add = Hinzufügen
    .title = Den genannten oder den aktuellen Punkt hinzufügen

studio_point-add_chosen = jeden gewählten Punkt hinzufügen
    .title = Jeden Punkt hinzufügen, der in einer Aufnahme, im Raum oder in einer Liste gewählt wird

studio_point-clear = Leeren
    .title = Alle Punkte entfernen

studio_point-datum = Koordinatensystem

studio_point-origin = Ursprung

studio_point-on_axis = auf der X-Achse

studio_point-in_plane = in der XY-Ebene (optional)

studio_point-use_current = Den aktuellen Punkt verwenden ({ $role })

studio_point-remove_datum = Entfernen
    .title = Das Koordinatensystem des Bildverbands verwenden

studio_point-datum_removed = Das Koordinatensystem ist das des Bildverbands.

studio_point-datum_given = Koordinatensystem: { $points }

studio_point-datum_is = Ursprung { $origin }, X-Achse { $plane ->
        [none] in Richtung { $axis }, Lotrichtung aus Niveaus und Lotlinien
        *[other] durch { $axis }, { $plane } in der XY-Ebene
    }.

studio_point-datum_note = Das Koordinatensystem ist das des Bildverbands.
    .do = Drei Punkte angeben: Ursprung, X-Achse, XY-Ebene. Mit Niveaus oder Lotlinien genügen zwei.

studio_point-rename_or_forget = Punkt umbenennen oder löschen

studio_point-new_name = neuer Name

studio_point-rename = Umbenennen

studio_point-renamed = { $point } in { $to } umbenannt.

studio_point-forget = Löschen
    .title = Den aktuellen Punkt mit seinen Bildmessungen löschen

studio_point-forgotten = { $point } gelöscht, mit seinen Bildmessungen.

studio_point-masks = Masken

studio_point-mask_name = Name der Maske

studio_point-mask_default = Maske { $number }

studio_point-draw_mask = Fläche zeichnen
    .title = Die Ecken anklicken oder das Fadenkreuz dorthin bewegen und Eingabe drücken

studio_point-exclude = Fläche ausschließen

studio_point-last_corner = Zurück
    .title = Die letzte Ecke entfernen (Entf)

studio_point-cancel_mask = Abbrechen
    .title = Keine Maske zeichnen (Esc)

studio_point-mask_of_camera = in allen Aufnahmen der Kamera

studio_point-no_corner = Keine Ecke ist gezeichnet.
    .do = Die Ecken in einer Aufnahme anklicken.

studio_point-mask_given = { $mask } ist ausgeschlossen, sobald orient erneut läuft.

studio_point-mask_elsewhere = Die Fläche wird in { $image } gezeichnet; Esc beendet das.

studio_point-corners = { $n } { $n ->
        [one] Ecke
        *[other] Ecken
    }{ $image ->
        [none] {""}
        *[other]  in { $image }
    }.
    .do = Ecken durch Ziehen verschieben; Entf entfernt die letzte.

studio_point-masks_note = Masken gelten, sobald orient in diesem Projekt erneut läuft.{ $folder ->
        [none] {""}
        *[other]  Masken aus { $folder } sind ebenfalls gezeichnet.
    }

studio_point-edit_mask = { $mask } bearbeiten

studio_point-camera_of = Kamera von { $image }

studio_point-fiducials = Rahmenmarken

studio_point-fiducials_of = Rahmenmarken von { $image }: { $n } von { $of }

studio_point-find_fiducials = Übrige suchen
    .title = Die übrigen nahe ihren erwarteten Stellen messen

studio_point-fiducials_found = { $n } { $n ->
        [one] Rahmenmarke
        *[other] Rahmenmarken
    } gefunden

studio_point-click_fiducial = { $name } im Scan anklicken; Esc beendet.

studio_point-fiducials_note = Eine wählen und im Scan anklicken. Sie legen den Scan im Rahmen seiner Kamera fest.
