select-mask = Für { $count } { $name } wurde eine Maske mit { $n } Werten angegeben.
    .do = Einen Wert für jeden Eintrag oder Namen angeben.

select-twice = Die Auswahl von { $name } enthält einen Eintrag zweimal.
    .do = Jeden einmal angeben.
