features-unknown = Das Merkmalsverfahren { $name } ist unbekannt.
    .do = Eines von { LIST($known, most: 20) } angeben.

features-not_installed = Das Merkmalsverfahren { $name } benötigt { $packages }.
    .do = Installieren: { $command }; oder rootsift verwenden, das nichts weiter benötigt.
