table-more_errors = Es gibt weitere Fehler; der Rest der Datei wurde nicht gelesen.
