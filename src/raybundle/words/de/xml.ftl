xml-invalid = Das ist kein gültiges XML: { $detail }.
    .do = { $cut ->
        [yes] Die Datei neu beschaffen: Das Ende fehlt
       *[no] Diese Zeile korrigieren
     }.

xml-element_missing = Das Element { $path } fehlt.
    .do = Prüfen, ob die Datei vollständig ist.

xml-attribute_missing = Das Attribut { $name } fehlt.
    .do = Prüfen, ob die Datei vollständig ist.

xml-attribute_not_a_number = Attribut { $name }: { $value } ist keine endliche Zahl.
    .do = Eine Zahl bis höchstens { $largest } angeben.

xml-doctype = Der Dokumenttyp (DOCTYPE) wird aus Sicherheitsgründen abgelehnt.
    .do = Den Dokumenttyp aus der Datei löschen.

xml-empty = Die Datei hat kein Wurzelelement; erwartet wird { $root }.
    .do = Prüfen, ob es die richtige Datei ist.

xml-root_element = Das Wurzelelement ist { $name }, nicht { $root }.
    .do = Prüfen, ob es die richtige Datei ist.
