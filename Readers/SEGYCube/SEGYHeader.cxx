// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "SEGYHeader.h"

#include "Common/Text/FileErrors.h"
#include "Common/Text/InputFile.h"
#include "SEGYLayout.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string_view>

namespace SeismicHorizons
{
namespace
{
constexpr int LineLength = 80;
constexpr int TapeLabelSize = 128;
constexpr std::int64_t MostTraces = std::int64_t(1) << 31; // Columns store trace numbers in 32 bits.
constexpr std::int64_t MostExtendedTexts = 1 << 15;

// Offsets of bytes from 1, as in the standard.
constexpr int IntervalByte = 3217;
constexpr int SamplesByte = 3221;
constexpr int FormatByte = 3225;
constexpr int UnitByte = 3255;
constexpr int ExtendedSamplesByte = 3269;
constexpr int ExtendedIntervalByte = 3273;
constexpr int ByteOrderMarkByte = 3297;
constexpr int RevisionByte = 3501;
constexpr int ExtendedTextsByte = 3505;
constexpr int AdditionalHeadersByte = 3507;
constexpr int TrailersByte = 3529;
constexpr int TraceSamplesByte = 115;
constexpr int TraceIntervalByte = 117;
constexpr double IntervalTolerance = 0.0011; // Milliseconds; traces state whole microseconds.
constexpr std::uint32_t ByteOrderNumber = 16909060; // bytes 01 02 03 04

using HeaderBytes = std::vector<unsigned char>;

class BinaryHeader
{
public:
  explicit BinaryHeader(const HeaderBytes& bytes)
    : Bytes(bytes)
  {
  }

  const unsigned char* At(int byte) const { return this->Bytes.data() + byte - 1; }
  int Unsigned16(int byte) const { return DecodeNumber<std::uint16_t>(this->At(byte), this->Order); }
  int Integer16(int byte) const { return DecodeNumber<std::int16_t>(this->At(byte), this->Order); }
  int Integer32(int byte) const { return DecodeNumber<std::int32_t>(this->At(byte), this->Order); }
  double Double(int byte) const { return DecodeNumber<double>(this->At(byte), this->Order); }

  /// Finds the byte order in which the format code is valid, or else the one with the smaller interval and number of
  /// samples.
  void FindOrder()
  {
    const auto isCode = [this](ByteOrder order)
    { return SampleSize(DecodeNumber<std::int16_t>(this->At(FormatByte), order)) > 0; };
    const auto number = [this](int byte, ByteOrder order)
    { return DecodeNumber<std::uint16_t>(this->At(byte), order); };
    const auto numbers = [&](ByteOrder order) { return number(IntervalByte, order) + number(SamplesByte, order); };
    const bool isMarked =
      DecodeNumber<std::uint32_t>(this->At(ByteOrderMarkByte), ByteOrder::LittleEndian) == ByteOrderNumber;
    const bool isLess = numbers(ByteOrder::LittleEndian) < numbers(ByteOrder::BigEndian);
    const bool isSwapped = !isCode(ByteOrder::BigEndian) && (isCode(ByteOrder::LittleEndian) || isLess);
    this->Order = isMarked || isSwapped ? ByteOrder::LittleEndian : ByteOrder::BigEndian;
  }

  /// The major revision is the first of two bytes. Invalid numbers give 0.
  int Revision() const
  {
    constexpr int last = 2;
    const int revision = this->At(RevisionByte)[this->IsRevisionSwapped() ? 1 : 0];
    return revision <= last ? revision : 0;
  }

  /// In revision 2.1 the second half of the number is the type of the survey.
  int AdditionalHeaders() const
  {
    const bool hasSurveyType = this->At(RevisionByte)[this->IsRevisionSwapped() ? 0 : 1] > 0;
    return hasSurveyType ? this->Integer16(AdditionalHeadersByte) : this->Integer32(AdditionalHeadersByte);
  }

  int ShortSamples() const { return this->Unsigned16(SamplesByte); }

  int Samples() const
  {
    const int extended = this->Revision() >= 2 ? this->Integer32(ExtendedSamplesByte) : 0;
    return extended > 0 ? extended : this->ShortSamples();
  }

  /// Microseconds; 0 if not stated.
  double Interval() const
  {
    const double extended = this->Revision() >= 2 ? this->Double(ExtendedIntervalByte) : 0.0;
    return extended > 0.0 && std::isfinite(extended) ? extended : this->Unsigned16(IntervalByte);
  }

  ByteOrder Order = ByteOrder::BigEndian;

private:
  /// Some programs swap the bytes in little-endian files; there is no revision 0.1, 0.2 or 1.2.
  bool IsRevisionSwapped() const
  {
    const unsigned char* const bytes = this->At(RevisionByte);
    return this->Order == ByteOrder::LittleEndian && bytes[0] < bytes[1];
  }

  const HeaderBytes& Bytes;
};

HeaderBytes ReadBytes(std::istream& stream, std::int64_t place, int size)
{
  HeaderBytes bytes(std::size_t(size), 0);
  stream.clear();
  stream.seekg(place);
  stream.read(reinterpret_cast<char*>(bytes.data()), size);
  bytes.resize(std::size_t(std::max<std::streamsize>(stream.gcount(), 0)));
  return bytes;
}

/// Since revision 1 a label with the revision and the word RECORD may come first, as on tapes.
int FindLabelSize(std::istream& stream)
{
  const HeaderBytes bytes = ReadBytes(stream, 0, TapeLabelSize);
  const std::string label(bytes.begin(), bytes.end());
  return label.size() == TapeLabelSize && label.compare(4, 2, "SY") == 0 && label.compare(9, 6, "RECORD") == 0
    ? TapeLabelSize
    : 0;
}

/// Blanks are the most frequent characters of headers.
bool IsEbcdic(const HeaderBytes& bytes)
{
  constexpr unsigned char ebcdicBlank = 0x40;
  const auto text = bytes.begin();
  return std::count(text, text + SEGYTextSize, ebcdicBlank) > std::count(text, text + SEGYTextSize, ' ');
}

/// Characters outside the table become blanks.
char FromEbcdic(unsigned char c)
{
  static const std::string_view table = "           .<(+|&         !$*);^-/        |,%_>?         `:#@'=\""
                                        " abcdefghi       jklmnopqr       ~stuvwxyz                      "
                                        "{ABCDEFGHI      }JKLMNOPQR      \\ STUVWXYZ      0123456789      ";
  return c < 0x40 ? ' ' : table[c - 0x40];
}

char ToASCII(unsigned char c, bool isEbcdic)
{
  return isEbcdic ? FromEbcdic(c) : c > ' ' && c < 0x7f ? char(c) : ' ';
}

std::vector<std::string> ReadText(const HeaderBytes& bytes, bool isEbcdic)
{
  std::vector<std::string> lines;
  for (int first = 0; first < SEGYTextSize; first += LineLength)
  {
    std::string line;
    for (int n = first; n < first + LineLength; ++n)
    {
      line += ToASCII(bytes[std::size_t(n)], isEbcdic);
    }
    line.erase(line.find_last_not_of(' ') + 1);
    lines.push_back(line);
  }
  return lines;
}

/// Returns -1 if no text ends the sequence.
int CountTexts(std::istream& stream, std::int64_t fileSize, const SEGYHeader& header)
{
  const std::string end = "((SEG:ENDTEXT))";
  std::int64_t place = header.LabelSize + SEGYFileHeaderSize;
  for (int count = 0; place + SEGYTextSize <= fileSize && count < MostExtendedTexts; ++count, place += SEGYTextSize)
  {
    std::string start;
    for (const unsigned char c : ReadBytes(stream, place, LineLength))
    {
      const char letter = ToASCII(c, header.IsEbcdic);
      start += letter == ' ' ? "" : std::string(1, letter >= 'a' && letter <= 'z' ? char(letter - 'a' + 'A') : letter);
    }
    if (start.compare(0, end.size(), end) == 0)
    {
      return count + 1;
    }
  }
  return -1;
}

void CheckWhole(SEGYHeader& header, std::int64_t fileSize, int firstSamples, const SEGYHeaderOptions& options)
{
  const std::int64_t size = fileSize - header.FirstTrace;
  const auto traceSize = std::int64_t(header.TraceSize());
  std::ostringstream text;
  if (size < traceSize)
  {
    text << "a file of " << fileSize << " bytes, expected at least " << header.FirstTrace + traceSize
         << " for the header and a trace of " << header.Samples << " samples (" << FormatName(header.Format) << ')';
    throw FileError(FileProblem::CutOff, text.str());
  }
  if (size % traceSize != 0)
  {
    text << "a file that ends " << size % traceSize << " bytes into trace " << size / traceSize + 1
         << ", expected whole traces of " << traceSize << " bytes, with " << header.Samples << " samples ("
         << FormatName(header.Format) << ")";
    if (!options.IgnoreIncompleteTrace)
    {
      if (firstSamples > 0 && firstSamples != header.Samples)
      {
        text << "; the first trace says " << firstSamples << " samples: traces of different lengths are not read";
      }
      text << ". Set IgnoreIncompleteTrace to read all but the last, or NumberOfSamples where it is another one";
      throw FileError(FileProblem::CutOff, text.str());
    }
    header.Warnings.push_back(text.str());
  }
  if (size / traceSize >= MostTraces)
  {
    text << size / traceSize << " traces, expected less than 2^31";
    throw InputError(text.str());
  }
}

/// Refuses extensions of revision 2 that move the traces.
void CheckRevision2(const BinaryHeader& binary)
{
  if (binary.Revision() < 2)
  {
    return;
  }
  const int headers = binary.AdditionalHeaders();
  const int trailers = binary.Integer32(TrailersByte);
  if (headers != 0 || trailers != 0)
  {
    throw InputError("revision 2 with " + std::to_string(headers) + " additional trace headers (byte 3507) and " +
      std::to_string(trailers) + " trailers (byte 3529), expected none");
  }
}

/// Likely layouts come first. Revision 0 has no extended texts, and any value in their field; but some programs write
/// texts without the revision.
std::vector<SEGYLayout> ListLayouts(
  const BinaryHeader& binary, const SEGYExtents& file, int statedTexts, const SEGYHeaderOptions& options)
{
  std::vector<int> texts = { 0 };
  texts.insert(binary.Revision() > 0 ? texts.begin() : texts.end(), statedTexts);
  std::vector<SEGYLayout> layouts;
  for (const int count : texts)
  {
    const int ofTrace = std::max(0, file.SamplesAt(file.FirstTrace({ count, 0 })));
    for (const int samples : { binary.Samples(), binary.ShortSamples(), ofTrace })
    {
      layouts.push_back({ count, options.Samples > 0 ? options.Samples : samples });
    }
  }
  const auto isEmpty = [](const SEGYLayout& layout) { return layout.Samples == 0; };
  layouts.erase(std::remove_if(layouts.begin(), layouts.end(), isEmpty), layouts.end());
  return layouts;
}

void FindLayout(SEGYHeader& header, const BinaryHeader& binary, std::istream& stream, std::int64_t fileSize,
  const SEGYHeaderOptions& options)
{
  const auto samplesAt = [&](std::int64_t trace)
  {
    const HeaderBytes bytes = ReadBytes(stream, header.LabelSize + trace + TraceSamplesByte - 1, 2);
    return bytes.size() == 2 ? int(DecodeNumber<std::uint16_t>(bytes.data(), header.Order)) : -1;
  };
  const SEGYExtents file = { fileSize - header.LabelSize, SampleSize(int(header.Format)), samplesAt };
  const int stated = binary.Integer16(ExtendedTextsByte);
  const int texts = stated >= 0 ? stated : header.Revision > 0 ? CountTexts(stream, fileSize, header) : 0;
  const std::vector<SEGYLayout> layouts = ListLayouts(binary, file, std::max(0, texts), options);
  if (layouts.empty())
  {
    throw InputError("0 samples in a trace, in the header (byte 3221) and in the first trace (byte 115), expected at "
                     "least 1; set NumberOfSamples");
  }
  const SEGYLayout layout = ChooseLayout(file, layouts);
  header.ExtendedTexts = layout.Texts;
  header.FirstTrace = header.LabelSize + file.FirstTrace(layout);
  header.Samples = layout.Samples;
  header.HasOwnSamples = options.Samples > 0 || layout.Samples == binary.Samples();
  const std::string behind = ": the traces begin after " + std::to_string(layout.Texts);
  if (header.Revision > 0 && texts < 0)
  {
    header.Warnings.push_back("extended text headers (byte 3505) without an end" + behind);
  }
  else if (header.Revision > 0 && texts != layout.Texts)
  {
    header.Warnings.push_back(std::to_string(texts) + " extended text headers (byte 3505)" + behind);
  }
  if (binary.Samples() > 0 && !header.HasOwnSamples)
  {
    header.Warnings.push_back(std::to_string(binary.Samples()) +
      " samples in the header (byte 3221): traces are read with " + std::to_string(layout.Samples) +
      ", as they state (byte 115)");
  }
}

/// Few of the first 3200 bytes may be control characters, in ASCII or EBCDIC.
bool BeginsWithText(std::istream& stream)
{
  stream.seekg(0);
  const std::string text = PeekText(stream, SEGYTextSize);
  const auto isControl = [](char c)
  { return c > 0 && c < ' ' && std::string_view("\n\r\t\x15\x05").find(c) == std::string_view::npos; };
  constexpr std::size_t most = SEGYTextSize / 100;
  return std::size_t(std::count_if(text.begin(), text.end(), isControl)) <= most;
}
}

//----------------------------------------------------------------------------------------------------------------------
SEGYHeader ReadSEGYHeader(std::istream& stream, std::int64_t fileSize, const SEGYHeaderOptions& options)
{
  SEGYHeader header;
  header.LabelSize = FindLabelSize(stream);
  const HeaderBytes bytes = ReadBytes(stream, header.LabelSize, SEGYFileHeaderSize);
  if (bytes.size() < std::size_t(SEGYFileHeaderSize))
  {
    throw FileError(FileProblem::CutOff,
      "a file of " + std::to_string(bytes.size()) + " bytes, expected SEG-Y, which begins with a header of " +
        std::to_string(SEGYFileHeaderSize));
  }
  BinaryHeader binary(bytes);
  binary.FindOrder();
  header.IsEbcdic = IsEbcdic(bytes);
  header.Text = ReadText(bytes, header.IsEbcdic);
  header.Order = binary.Order;
  const bool isGiven = options.FormatCode > 0;
  const int code = isGiven ? options.FormatCode : binary.Integer16(FormatByte);
  CheckFormatCode(code, isGiven ? "" : " at byte 3225");
  header.Format = SEGYFormat(code);
  header.Revision = binary.Revision();
  header.Interval = binary.Interval() / 1000.0;
  const int unit = binary.Integer16(UnitByte);
  header.LengthUnit = unit == 1 ? "m" : unit == 2 ? "ft" : "";
  CheckRevision2(binary);
  FindLayout(header, binary, stream, fileSize, options);

  const HeaderBytes first = ReadBytes(stream, header.FirstTrace, SEGYTraceHeaderSize);
  const bool hasTrace = first.size() == std::size_t(SEGYTraceHeaderSize);
  const auto ofTrace = [&](int byte)
  { return hasTrace ? int(DecodeNumber<std::uint16_t>(&first[byte - 1], header.Order)) : 0; };
  CheckWhole(header, fileSize, ofTrace(TraceSamplesByte), options);
  const double interval = ofTrace(TraceIntervalByte) / 1000.0;
  if (header.Interval > 0.0 && interval > 0.0 && std::abs(header.Interval - interval) > IntervalTolerance)
  {
    std::ostringstream text;
    text << "a sample interval of " << header.Interval << " ms in the header (byte 3217) and of " << interval
         << " in the first trace (byte 117): the header is used; set VerticalStep to change it";
    header.Warnings.push_back(text.str());
  }
  header.Interval = header.Interval > 0.0 ? header.Interval : interval;
  header.Traces = (fileSize - header.FirstTrace) / std::int64_t(header.TraceSize());
  return header;
}

//----------------------------------------------------------------------------------------------------------------------
bool IsSEGY(std::istream& stream)
{
  const HeaderBytes bytes = ReadBytes(stream, FindLabelSize(stream), SEGYFileHeaderSize + SEGYTraceHeaderSize);
  if (bytes.size() < std::size_t(SEGYFileHeaderSize + SEGYTraceHeaderSize))
  {
    return false;
  }
  BinaryHeader binary(bytes);
  binary.FindOrder();
  const bool hasSamples = binary.Samples() > 0 || binary.Unsigned16(SEGYFileHeaderSize + TraceSamplesByte) > 0;
  return SampleSize(binary.Integer16(FormatByte)) > 0 && hasSamples;
}

//----------------------------------------------------------------------------------------------------------------------
bool IsSEGYFile(const std::string& path)
{
  const std::string extension = ExtensionOf(path);
  const bool isOwn = extension == "sgy" || extension == "segy" || extension == "seg";
  return IsRecognised(path.c_str(),
    [&path, isOwn](std::istream&)
    {
      const auto place = std::filesystem::u8path(path);
      std::ifstream stream(place, std::ios::binary); // without decoding gzip
      return IsSEGY(stream) &&
        (isOwn ||
          (BeginsWithText(stream) &&
            ReadSEGYHeader(stream, std::int64_t(std::filesystem::file_size(place))).Traces > 0));
    });
}
}
