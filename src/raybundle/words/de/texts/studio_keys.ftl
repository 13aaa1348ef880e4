studio_keys-title = Tasten

studio_keys-anywhere = Überall

studio_keys-in_photograph = In einer Aufnahme

studio_keys-by_mouse = Maus

studio_keys-new_point = neuer Punkt

studio_keys-next_image = nächstes Bild, in dem der aktuelle Punkt sichtbar und nicht gemessen ist

studio_keys-worst = nächster der schlechtesten

studio_keys-ctrl_z = Strg Z

studio_keys-undo = rückgängig

studio_keys-ctrl_shift_z = Strg Umschalt Z

studio_keys-redo = wiederholen

studio_keys-snap = nächste Art des Fangens

studio_keys-loupe = Lupe: solange gehalten, oder ein und aus

studio_keys-centre = alle Bilder auf den aktuellen Punkt zentrieren

studio_keys-panes = 1, 2 oder 4 Bilder

studio_keys-neighbour = voriges, nächstes Bild

studio_keys-no_point = kein aktueller Punkt

studio_keys-name = den Namen eines Punkts eingeben

studio_keys-this_table = diese Tabelle

studio_keys-arrows = Pfeiltasten

studio_keys-hair = das Fadenkreuz verschieben; mit Strg um 1 px

studio_keys-mark = den aktuellen Punkt am Fadenkreuz messen

studio_keys-shift_arrows = Umschalt und Pfeile

studio_keys-move = die Bildmessung des aktuellen Punkts um 0,1 px verschieben; mit Alt um 0,01 px

studio_keys-delete = Entf

studio_keys-remove = die Bildmessung entfernen

studio_keys-choose = den Bildpunkt hier wählen

studio_keys-reject = die Bildbeobachtung hier verwerfen oder wieder verwenden

studio_keys-of_mask = Eingabe, Entf, Esc

studio_keys-mask = beim Zeichnen einer Maske: Ecke hinzufügen, letzte entfernen, abbrechen

studio_keys-zoom = vergrößern, verkleinern

studio_keys-whole = ganze Aufnahme

studio_keys-pixels = volle Auflösung

studio_keys-turn = drehen

studio_keys-click = Klick

studio_keys-click_deed = den aktuellen Punkt messen; auf einer Bildmessung: sie wählen

studio_keys-ctrl_click = Strg Klick

studio_keys-drag = Ziehen

studio_keys-drag_deed = die Aufnahme oder eine Bildmessung verschieben

studio_keys-wheel = Rad

studio_keys-shift_click = Umschalt Klick in der Liste

studio_keys-beside = das Bild daneben öffnen

studio_keys-close = Schließen
    .title = Diese Tabelle schließen (Esc)
