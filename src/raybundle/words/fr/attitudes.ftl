attitudes = Les attitudes de { $n } photographie(s) sont observées ({ $convention }, { $source }).
