sameness-unlike = andere Zeilen: { $table }

sameness-all = alle { $n } Tabellen sind bis zum letzten Bit gleich

sameness-some = { $n } von { $of } Tabellen sind bis zum letzten Bit gleich, die anderen auf { NUM($difference, digits: 1) }.
    .why = Bezogen auf die größte Zahl einer Spalte; die größte Abweichung steht in { $name } von { $table }.
