Attribute VB_Name = "BioprintPredictModule"
' Predictions in Excel for Windows, by the bioprint-predict command.
'
'   =BioprintPredict("--radius 50um --flowrate 141uL/h", "nozzle.stress_max")
'
' is one value in SI units. PredictSelection answers a selected table whose first row names options, such as
' "radius [um]", "flowrate [uL/h]", "alpha", and writes the values of ANSWERS to the right of it.
'
' To install: Alt+F11, File > Import File. PROGRAM may need a full path.
'
' Shell returns no output, so the answer goes through a file. Numbers are written by Str and read by Val, which
' always use the decimal point; CStr and CDbl follow the locale.

Option Explicit

Private Const PROGRAM As String = "bioprint-predict.exe"
Private Const ANSWERS As String = "nozzle.stress_max exit.elongational_stress nozzle.pressure_gradient"

Public Function BioprintPredict(question As String, path As String) As Variant
    Dim lines As Variant
    lines = AnswerLines("-q " & question & " --get " & path)
    If UBound(lines) < 0 Then
        BioprintPredict = CVErr(xlErrNA)
    ElseIf lines(0) = "null" Then
        BioprintPredict = CVErr(xlErrNA)
    Else
        BioprintPredict = NumberIn(CStr(lines(0)))
    End If
End Function

Public Sub PredictSelection()
    Dim table As Range
    Dim batch As String
    Dim arguments As String
    Dim lines As Variant
    Dim paths As Variant
    Dim values As Variant
    Dim filled As Variant
    Dim corner As Range
    Dim i As Long
    Dim k As Long
    If TypeName(Selection) <> "Range" Then
        MsgBox "Select a table first; its first row names options."
        Exit Sub
    End If
    Set table = Selection
    paths = Split(ANSWERS, " ")
    filled = FilledRows(table)
    If UBound(filled) < 1 Then
        MsgBox "Select a table first; its first row names options."
        Exit Sub
    End If
    batch = ScratchName(".csv")
    WriteText batch, TableAsCsv(table, filled)
    arguments = "-q --batch """ & batch & """"
    For k = 0 To UBound(paths)
        arguments = arguments & " --get " & paths(k)
    Next k
    lines = AnswerLines(arguments)
    Kill batch
    Set corner = table.Cells(1, table.Columns.Count + 1)
    For k = 0 To UBound(paths)
        corner.Offset(filled(0) - 1, k).Value = paths(k)
    Next k
    For i = 1 To UBound(filled)
        ' One line for each row; with any other number nobody knows whose they are.
        If UBound(lines) = UBound(filled) - 1 Then
            values = Split(lines(i - 1), vbTab)
        Else
            values = Array("null")
        End If
        For k = 0 To UBound(values)
            corner.Offset(filled(i) - 1, k).Value = NumberIn(CStr(values(k)))
        Next k
    Next i
End Sub

Private Function NumberIn(text As String) As Variant
    If text = "null" Then
        NumberIn = "no answer"
    ElseIf IsNumber(text) Then
        NumberIn = Val(text)
    Else
        NumberIn = text
    End If
End Function

' As the command writes them. A name may begin with a digit.
Private Function IsNumber(text As String) As Boolean
    Dim i As Long
    IsNumber = False
    If text = "" Then Exit Function
    If InStr("-0123456789", Left(text, 1)) = 0 Then Exit Function
    For i = 1 To Len(text)
        If InStr("-+.e0123456789", Mid(text, i, 1)) = 0 Then Exit Function
    Next i
    IsNumber = True
End Function

' The lines the command writes with these arguments; none when it has no answer.
Private Function AnswerLines(arguments As String) As Variant
    Dim shell As Object
    Dim file As String
    Dim text As String
    Dim handle As Integer
    file = ScratchName(".txt")
    Set shell = CreateObject("WScript.Shell")
    ' 0: no window; True: wait until it has ended.
    shell.Run """" & PROGRAM & """ " & arguments & " --output """ & file & """", 0, True
    If Dir(file) = "" Then
        AnswerLines = Split("", vbLf)
        Exit Function
    End If
    handle = FreeFile
    Open file For Input As #handle
    text = Input(LOF(handle), #handle)
    Close #handle
    Kill file
    text = Replace(text, vbCr, "")
    If Right(text, 1) = vbLf Then text = Left(text, Len(text) - 1)
    AnswerLines = Split(text, vbLf)
End Function

' The rows of the table that hold anything, the names first. An empty one asks nothing and has no answer.
Private Function FilledRows(table As Range) As Variant
    Dim found() As Long
    Dim count As Long
    Dim row As Long
    Dim column As Long
    For row = 1 To table.Rows.Count
        For column = 1 To table.Columns.Count
            If Trim(CStr(table.Cells(row, column).Value)) <> "" Then
                ReDim Preserve found(count)
                found(count) = row
                count = count + 1
                Exit For
            End If
        Next column
    Next row
    If count = 0 Then
        FilledRows = Array()
    Else
        FilledRows = found
    End If
End Function

' Comma-separated with decimal points, whatever the locale; texts in quotes.
Private Function TableAsCsv(table As Range, filled As Variant) As String
    Dim csv As String
    Dim cell As Range
    Dim i As Long
    Dim column As Long
    For i = 0 To UBound(filled)
        For column = 1 To table.Columns.Count
            If column > 1 Then csv = csv & ","
            Set cell = table.Cells(filled(i), column)
            If IsEmpty(cell.Value) Then
                csv = csv & ""
            ElseIf VarType(cell.Value) = vbDouble Then
                csv = csv & Trim(Str(cell.Value))
            Else
                csv = csv & """" & Replace(CStr(cell.Value), """", """""") & """"
            End If
        Next column
        csv = csv & vbLf
    Next i
    TableAsCsv = csv
End Function

Private Function ScratchName(ending As String) As String
    Static count As Long
    count = count + 1
    Randomize
    ScratchName = Environ("TEMP") & "\bioprint-" & Format(Now, "yyyymmddhhnnss") & "-" & _
        Trim(Str(Int(Rnd * 1000000))) & "-" & Trim(Str(count)) & ending
End Function

Private Sub WriteText(file As String, text As String)
    Dim stream As Object
    Set stream = CreateObject("ADODB.Stream")
    stream.Type = 2
    stream.Charset = "utf-8"
    stream.Open
    stream.WriteText text
    stream.SaveToFile file, 2
    stream.Close
End Sub
