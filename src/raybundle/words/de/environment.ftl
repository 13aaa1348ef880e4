environment-native_unknown = RAYBUNDLE_NATIVE = { $chosen } ist unbekannt.
    .do = Einen Wert aus { $known } setzen oder die Variable löschen.
