report_record-title = Dokumentationsblatt

report_record-entry = Eintrag

report_record-record = Angabe

report_record-part = { $part ->
        [object] Objekt
        [recording] Aufnahme
        *[delivery] Übergabe
    }

report_record-from_photographs = aus den Aufnahmen

report_record-sources = Objekt: nach dem Core Data Index to Historic Buildings and Monuments (Europarat, CIDOC).
    .why = Aufnahme: nach den 3x3-Regeln der CIPA.

report_record-name = { $name ->
        [title] Titel
        [client] Auftraggeber
        [operator] Bearbeiter
        [object] Objekt
        [place] Ort
        [date] Datum
        [instruments] Geräte
        [rights] Rechte
        [reference] Nachweise
        [kind] Art
        [dating] Datierung
        [persons] Personen
        [materials] Materialien
        [condition] Zustand
        [protection] Schutz
        [description] Beschreibung
        [purpose] Zweck
        [conditions] Bedingungen
        [control] Passpunkte und Maßstab
        *[archive] Archiv
    }
