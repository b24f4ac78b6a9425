# No table: says where the data of a chart is from.
