studio_space-no_graphics = Dieser Browser zeigt keine 3D-Grafik (WebGL ist abgeschaltet).
    .why = Tabellen und Bilder enthalten dieselben Punkte.

studio_space-canvas = Objektraum: Pfeiltasten drehen, + und - vergrößern, 0 zeigt alles

studio_space-click = Einen Punkt anklicken, um ihn zu wählen; einen Standpunkt, um sein Bild zu öffnen.

studio_space-click_points = Die Punkte anklicken, die gemessen werden.

studio_space-points_shown = { $n } von { $of } Punkten sind gezeigt.

studio_space-beyond = jenseits der Grenze: { $n }

studio_space-point = { $name ->
        [none] Punkt
        *[other] { $name }
    }: { $n } { $n ->
        [one] Strahl
        *[other] Strahlen
    }{ $sigma ->
        [none] {""}
        *[other] , Sigma { $sigma }
    }{ $w ->
        [none] {""}
        *[other] , |w| { $w }
    }

studio_space-colour = Farbe

studio_space-colouring = { $by ->
        [role] Rolle
        [rays] Strahlen
        [sigma] Sigma
        [w] größtes |w|
        [redundancy] Redundanzanteil
        *[residual] Verbesserung
    }

studio_space-up_to = { $by ->
        [w] |w|
        [redundancy] kleinster Redundanzanteil
        [residual] Verbesserung (RMS)
        *[sigma] Sigma
    } ≤ { $limit }

studio_space-few_rays = höchstens 2 Strahlen

studio_space-unknown = unbekannt

studio_space-role = { $role ->
        [control] Passpunkte
        [check] Kontrollpunkte
        *[tie] Verknüpfungspunkte
    }

studio_space-shown = { $name ->
        [points] Punkte
        [stations] Standpunkte
        [bars] Maßstabsstrecken
        *[ellipsoids] Ellipsoide
    }

studio_space-enlargement = Vergrößerung der Fehlerellipsoide

studio_space-all = Alles
    .title = Alles zeigen (0)

studio_space-measure = messen
    .title = Punkte anklicken: 2 ergeben eine Strecke, 3 einen Winkel, mehr eine Fläche

studio_space-measured = Größe

studio_space-quantity = { $kind ->
        [coordinates] Koordinaten
        [distance] Strecke
        [angle] Winkel
        [area] Fläche
        [length] Länge eines Linienzugs
        [plane] Ebenheit
        [line] Geradheit
        [to_plane] erster Punkt zu einer Ebene
        [to_line] erster Punkt zu einer Geraden
        *[any] nach Anzahl der Punkte
    }

studio_space-add_current = Aktuellen Punkt hinzufügen
    .title = Auch zum aktuellen Punkt messen

studio_space-clear = Leeren
    .title = Eine neue Messung beginnen

studio_space-pairs = Verknüpfungsgraph
    .title = Linien zwischen Aufnahmen mit gemeinsamen Punkten zeichnen

studio_space-fewest = Kleinste Anzahl gemeinsamer Punkte einer Verbindung

studio_space-weak_pairs = < { $limit } gemeinsame Punkte

studio_space-section = Schnitt
    .title = Nur die Punkte zwischen zwei Ebenen zeichnen

studio_space-across = { $across ->
        [side] lotrecht, von der Seite
        [front] lotrecht, von vorn
        [level] waagerecht
        [points] durch 3 gemessene Punkte
        *[none] keiner
    }

studio_space-section_place = Lage des Schnitts

studio_space-section_thickness = Dicke des Schnitts

studio_space-three_points_first = zuerst zwischen drei Punkten messen
