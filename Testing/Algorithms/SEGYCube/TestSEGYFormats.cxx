// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// All formats of samples, byte orders, headers and texts.

#include "Readers/SEGYCube/SEGYImage.h"
#include "Tools/Check.h"
#include "WindowSample.h"

#include <array>
#include <limits>
#include <random>
#include <sstream>

using namespace SEGYSample;

namespace
{
constexpr std::array<SEGYFormat, 11> AllFormats = { SEGYFormat::IbmFloat, SEGYFormat::Integer32, SEGYFormat::Integer16,
  SEGYFormat::IeeeFloat, SEGYFormat::IeeeDouble, SEGYFormat::Integer24, SEGYFormat::Integer8, SEGYFormat::Unsigned32,
  SEGYFormat::Unsigned16, SEGYFormat::Unsigned24, SEGYFormat::Unsigned8 };
constexpr std::array<ByteOrder, 2> Orders = { ByteOrder::BigEndian, ByteOrder::LittleEndian };

float Convert(std::int64_t bits, SEGYFormat format, ByteOrder order)
{
  const int size = SizeOf(format);
  CHECK_EQUAL(std::size_t(size), SampleSize(int(format)));
  Bytes bytes(std::size_t(size), order);
  bytes.Put(1, size, bits);
  float value = 0.0f;
  ToFloats(reinterpret_cast<const unsigned char*>(bytes.Text.data()), 1, format, order, &value);
  return value;
}

void EveryFormatIsRead()
{
  for (const SEGYFormat format : AllFormats)
  {
    for (const ByteOrder order : Orders)
    {
      File file;
      file.Format = format;
      file.Order = order;
      const SEGYCube cube = Read(file);
      CHECK(cube.Header.Order == order);
      CHECK(cube.Header.Format == format);
      CHECK_EQUAL(CountWrong(file, cube), 0);
    }
  }
}

void SignsAndExtremesAreKept()
{
  for (const ByteOrder order : Orders)
  {
    CHECK_EQUAL(Convert(-1, SEGYFormat::Integer8, order), -1.0f);
    CHECK_EQUAL(Convert(-128, SEGYFormat::Integer8, order), -128.0f);
    CHECK_EQUAL(Convert(255, SEGYFormat::Unsigned8, order), 255.0f);
    CHECK_EQUAL(Convert(-32768, SEGYFormat::Integer16, order), -32768.0f);
    CHECK_EQUAL(Convert(65535, SEGYFormat::Unsigned16, order), 65535.0f);
    CHECK_EQUAL(Convert(-8388608, SEGYFormat::Integer24, order), -8388608.0f);
    CHECK_EQUAL(Convert(8388607, SEGYFormat::Integer24, order), 8388607.0f);
    CHECK_EQUAL(Convert(16777215, SEGYFormat::Unsigned24, order), 16777215.0f);
    CHECK_EQUAL(Convert(-2147483648LL, SEGYFormat::Integer32, order), -2147483648.0f);
    CHECK_EQUAL(Convert(4294967295LL, SEGYFormat::Unsigned32, order), 4294967296.0f); // rounded
    CHECK_EQUAL(Convert(Bits(-0.1, SEGYFormat::IeeeFloat), SEGYFormat::IeeeFloat, order), -0.1f);
    CHECK_EQUAL(Convert(Bits(-0.1, SEGYFormat::IeeeDouble), SEGYFormat::IeeeDouble, order), -0.1f);
    CHECK(std::isinf(Convert(Bits(1e300, SEGYFormat::IeeeDouble), SEGYFormat::IeeeDouble, order)));
  }
}

/// Known numbers, and those that are no normal ones: a 0 with an exponent, and fractions with leading zeros.
void FloatsOfIbmAreExact()
{
  const auto convert = [](std::uint32_t bits) { return Convert(bits, SEGYFormat::IbmFloat, ByteOrder::BigEndian); };
  CHECK_EQUAL(convert(0xc276a000), -118.625f);
  CHECK_EQUAL(convert(0x41100000), 1.0f);
  CHECK_EQUAL(convert(0x00000000), 0.0f);
  CHECK_EQUAL(convert(0x40000000), 0.0f);
  CHECK_EQUAL(convert(0x40000001), std::ldexp(1.0f, -24));
  CHECK_EQUAL(convert(0x42000001), std::ldexp(1.0f, -16));
  CHECK_EQUAL(convert(0x00100000), 0.0f); // 5e-79
  CHECK(std::isinf(convert(0x7fffffff))); // 7e75
  for (int exponent = 34; exponent < 96; ++exponent) // all that a float holds
  {
    for (const std::uint32_t fraction : { 0x100000u, 0x123457u, 0x800001u, 0xffffffu })
    {
      CHECK_EQUAL(double(convert(std::uint32_t(exponent) << 24 | fraction)),
        std::ldexp(double(fraction), 4 * (exponent - 64) - 24));
    }
  }
}

/// All signs and exponents with many fractions each, by the formula: the bits are those of the nearest float, and the
/// sign stays where that is 0 or infinite.
void FloatsOfIbmFollowTheFormula()
{
  constexpr int fractions = 4096;
  std::mt19937 random(1);
  for (std::uint32_t high = 0; high < 256; ++high)
  {
    for (int n = 0; n < fractions; ++n)
    {
      const std::uint32_t fraction = (random() & 0xffffff) >> (n % 25);
      const double value =
        std::ldexp(high < 128 ? double(fraction) : -double(fraction), 4 * (int(high % 128) - 64) - 24);
      const float found = Convert(high << 24 | fraction, SEGYFormat::IbmFloat, Orders[n % 2]);
      if (!CHECK_EQUAL(found, float(value)) || !CHECK_EQUAL(std::signbit(found), high >= 128))
      {
        return;
      }
    }
  }
}

void TextsAreDecoded()
{
  for (const bool isEbcdic : { false, true })
  {
    File file;
    file.IsEbcdic = isEbcdic;
    const SEGYCube cube = Read(file);
    CHECK(cube.Header.IsEbcdic == isEbcdic);
    CHECK_EQUAL(cube.Header.Text.size(), 40u);
    CHECK_EQUAL(cube.Header.Text.front(), std::string("C1 LINE OF TEXT"));
    CHECK_EQUAL(cube.Header.Text.back(), std::string("C40 LINE OF TEXT"));
  }
}

void ExtendedTextsAreSkipped()
{
  File file;
  file.ExtendedTexts = 3;
  SEGYCube cube = Read(file);
  CHECK_EQUAL(cube.Header.ExtendedTexts, 3);
  CHECK_EQUAL(CountWrong(file, cube), 0);
  file.IsEbcdic = false;
  file.ExtendedTextsInHeader = -1; // up to the one that ends them
  cube = Read(file);
  CHECK_EQUAL(cube.Header.ExtendedTexts, 3);
  CHECK_EQUAL(CountWrong(file, cube), 0);
  file.ExtendedTexts = 0;
  file.Revision = 0; // which knows no such texts
  CHECK_EQUAL(Read(file).Header.ExtendedTexts, 0);
}

void Revision2HasNumbersOfItsOwn()
{
  File file;
  file.Revision = 2;
  std::string bytes = Make(file);
  Bytes wide(400, ByteOrder::BigEndian);
  wide.Text = bytes.substr(3200, 400);
  wide.Put(21, 2, 0);
  wide.Put(69, 4, 5);
  wide.Put(73, 8, Bits(2000.5, SEGYFormat::IeeeDouble));
  bytes.replace(3200, 400, wide.Text);
  const SEGYCube cube = ReadSEGYCube(Write(bytes), {});
  CHECK_EQUAL(cube.Header.Revision, 2);
  CHECK_EQUAL(cube.Header.Samples, 5);
  CHECK_EQUAL(cube.Sampling.Step, 2.0005);
  wide.Put(307, 4, 1);
  bytes.replace(3200, 400, wide.Text);
  CHECK_THROWS_WITH(ReadSEGYCube(Write(bytes), {}),
    "revision 2 with 1 additional trace headers (byte 3507) and 0 trailers (byte 3529), expected none");
}

/// By revision 2.1 of 2023: bytes 3507 and 3508 count additional headers, 3509 and 3510 are the type of the survey.
void Revision21HasASurveyType()
{
  for (const ByteOrder order : { ByteOrder::BigEndian, ByteOrder::LittleEndian })
  {
    for (const bool isSwapped : { false, true }) // as in some little-endian files
    {
      File file;
      file.Order = order;
      const bool isLittle = order == ByteOrder::LittleEndian;
      file.Revision = isSwapped && isLittle ? 1 : 2;
      std::string bytes = Make(file);
      Bytes header(400, order);
      header.Text = bytes.substr(3200, 400);
      header.Put(302, 1, isSwapped && isLittle ? 2 : 1);
      header.Put(309, 2, 4);
      bytes.replace(3200, 400, header.Text);
      const SEGYCube cube = ReadSEGYCube(Write(bytes), {});
      CHECK_EQUAL(cube.Header.Revision, 2);
      CHECK_EQUAL(CountWrong(file, cube), 0);
      header.Put(307, 2, 3);
      bytes.replace(3200, 400, header.Text);
      CHECK_THROWS_WITH(ReadSEGYCube(Write(bytes), {}), "revision 2 with 3 additional trace headers (byte 3507)");
    }
  }
}

/// The label of 128 bytes that revision 1 describes, as copies of tapes have it.
void TapeLabelsArePassed()
{
  File file;
  file.IsEbcdic = false;
  file.ExtendedTexts = 2;
  file.ExtendedTextsInHeader = -1;
  std::string label = "   1SY1.0RECORDB001     32768ORG       28-NOV-2026SERIAL000001      ";
  label += "STORAGE SET";
  label.resize(128, ' ');
  const std::string bytes = label + Make(file);
  const SEGYCube cube = ReadSEGYCube(Write(bytes), {});
  CHECK_EQUAL(cube.Header.Text.front(), std::string("C1 LINE OF TEXT"));
  CHECK_EQUAL(cube.Header.ExtendedTexts, 2);
  CHECK_EQUAL(CountWrong(file, cube), 0);
  CHECK(Describe(cube, cube.Survey).find("text in ASCII, after a tape label") != std::string::npos);
  CHECK(IsSEGYFile(Write(bytes)));
  CHECK_THROWS_WITH(ReadSEGYCube(Write(bytes.substr(0, bytes.size() - 7)), {}), "a file that ends 253 bytes into");
}

void NumbersOfTheFirstTraceStandIn()
{
  File file;
  file.SamplesInHeader = 0;
  file.Interval = 0;
  file.TraceInterval = 2000;
  const SEGYCube cube = Read(file);
  CHECK(!cube.Header.HasOwnSamples);
  CHECK_EQUAL(cube.Sampling.Step, 2.0);
  CHECK_EQUAL(CountWrong(file, cube), 0);
  CHECK(Describe(cube, cube.Survey).find("12 traces of 5 samples (by the first trace)") != std::string::npos);
}

/// As in a file that is said to be of IBM, and has floats of IEEE.
void FormatsCanBeGiven()
{
  File file;
  file.Format = SEGYFormat::IeeeFloat;
  std::string bytes = Make(file);
  bytes[3225] = 1;
  SEGYOptions options;
  options.FormatCode = 5;
  CHECK_EQUAL(CountWrong(file, ReadSEGYCube(Write(bytes), options)), 0);
  CHECK(CountWrong(file, ReadSEGYCube(Write(bytes), {})) > 0);
  options.FormatCode = 4;
  CHECK_THROWS_WITH(ReadSEGYCube(Write(bytes), options), "format code 4, expected 1 (IBM float)");
}

void FilesAreRecognised()
{
  const auto recognise = [](const std::string& bytes)
  {
    std::istringstream stream(bytes);
    return IsSEGY(stream);
  };
  const std::string bytes = Make(File());
  CHECK(recognise(bytes));
  CHECK(recognise(bytes.substr(0, 3840)));
  CHECK(!recognise(bytes.substr(0, 3839)));
  CHECK(!recognise(""));
  CHECK(!recognise(std::string(10000, ' ')));
  CHECK(!recognise(std::string(10000, '\0')));
  File file;
  file.Order = ByteOrder::LittleEndian;
  CHECK(recognise(Make(file)));
}

/// Programs write 1e30 where there is no sample.
void NullsAreHidden()
{
  for (const SEGYFormat format : { SEGYFormat::IeeeFloat, SEGYFormat::IbmFloat, SEGYFormat::IeeeDouble })
  {
    File file;
    file.Format = format;
    std::string bytes = Make(file);
    const auto size = std::size_t(SizeOf(format));
    for (const double null : { 1e30, -1e30, 3e38, 999.0 })
    {
      Bytes sample(size, ByteOrder::BigEndian);
      sample.Put(1, int(size), Bits(null, format));
      bytes.replace(3600 + 6 * (240 + 5 * size) + 240 + 3 * size, size, sample.Text);
      const SEGYCube cube = ReadSEGYCube(Write(bytes), {});
      const CubeView view = MakeCubeView(cube, cube.Survey, VerticalDirection::Down, 0.5);
      const CubeImage image = ReadCubeImage(cube, view, Whole(cube), Monitor());
      const std::size_t place = 3 * 12 + 6;
      const bool isNull = null != 999.0;
      const DataArray* const marks = image.Image.PointData.Find("vtkGhostType");
      CHECK_EQUAL(image.Nulls, isNull ? 1 : 0);
      CHECK_EQUAL(marks != nullptr, isNull);
      CHECK_EQUAL(NullsText(image.Nulls).empty(), !isNull);
      CHECK_EQUAL(image.Image.PointData.Find("Amplitude")->As<float>()[place], isNull ? 0.0f : 999.0f);
      for (std::size_t n = 0; marks && n < 60; ++n)
      {
        CHECK_EQUAL(marks->As<unsigned char>()[n] != 0, n == place);
      }
    }
  }
}

void NumbersThatAreNotFiniteAreCounted()
{
  File file;
  file.Format = SEGYFormat::IeeeFloat;
  std::string bytes = Make(file);
  const std::size_t trace = 240 + 5 * 4;
  bytes.replace(3600 + 2 * trace + 240, 4, std::string("\x7f\xc0\0\0", 4));
  bytes.replace(3600 + 7 * trace + 244, 4, std::string("\xff\x80\0\0", 4));
  const SEGYCube cube = ReadSEGYCube(Write(bytes), {});
  CHECK_EQUAL(ReadWindow(cube, Whole(cube)).Marks.Nulls, 2);
  const SEGYCube sound = Read(file);
  CHECK_EQUAL(ReadWindow(sound, Whole(sound)).Marks.Nulls, 0);
}
}

int TestSEGYFormats(int, char*[])
{
  EveryFormatIsRead();
  SignsAndExtremesAreKept();
  FloatsOfIbmAreExact();
  FloatsOfIbmFollowTheFormula();
  TextsAreDecoded();
  ExtendedTextsAreSkipped();
  Revision2HasNumbersOfItsOwn();
  Revision21HasASurveyType();
  TapeLabelsArePassed();
  NumbersOfTheFirstTraceStandIn();
  FormatsCanBeGiven();
  FilesAreRecognised();
  NullsAreHidden();
  NumbersThatAreNotFiniteAreCounted();
  return Check::Result();
}
