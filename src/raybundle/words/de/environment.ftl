environment-native_unknown = RAYBUNDLE_NATIVE = { $chosen } ist unbekannt.
    .do = Einen Wert aus { $known } setzen oder die Variable löschen.

environment-native_missing = Die kompilierten Kerne fehlen.
    .why = Oberflächen werden nur mit kompiliertem Code gemessen.
    .do = Ein Wheel von raybundle installieren, oder einen C++-Compiler und erneut installieren; RAYBUNDLE_NATIVE=0 aufheben.
