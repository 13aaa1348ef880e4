estimate-no_list = Die zu schätzenden Parameter sind aufzuzählen.
    .do = Eine Liste aus { LIST($known, most: 20) } angeben.

estimate-neither_auto_nor_list = { $value } ist weder "auto" noch eine Liste von Parametern.
    .do = "auto" oder eine Liste aus { LIST($known, most: 20) } angeben.
