record-empty = Das Aufnahmeblatt hat keinen Eintrag.

record-next = { $oriented ->
        [yes] orient oder mark adjust noch einmal ausführen: der Bericht übernimmt das Aufnahmeblatt.
        *[no] raybundle orient ausführen: der Bericht übernimmt das Aufnahmeblatt.
    }
