// Agreement with Qt's implementation of RFC 8949: both write the same bytes, and messages written
// by Qt are decoded.
#include <wire_test/messages.hpp>

#include <QByteArray>
#include <QCborArray>
#include <QCborStreamWriter>
#include <QCborValue>
#include <QString>
#include <cstring>

#include <gtest/gtest.h>

namespace gs::wire::test {
namespace {

constexpr int kTimes = 200;
constexpr std::uint32_t kSequence = 0xFEDCBA98U;

QByteArray to_qt(const Bytes& bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), static_cast<int>(bytes.size())};
}

Bytes from_qt(const QByteArray& bytes) {
  return {bytes.begin(), bytes.end()};
}

float float_of(const Field& field) {
  const auto bits = static_cast<std::uint32_t>(field.number);
  float value = 0.0F;
  std::memcpy(&value, &bits, sizeof value);
  return value;
}

std::vector<std::uint64_t> head_of(const Uplink& message) {
  std::vector<std::uint64_t> head = {static_cast<std::uint64_t>(message.kind), kSequence,
                                     message.sample};
  if (message.kind != UplinkKind::kHello) {
    head.push_back(message.start_number);
  }
  return head;
}

std::vector<std::uint64_t> head_of(const Downlink& message) {
  return {static_cast<std::uint64_t>(message.kind), kSequence, message.session};
}

// Number of items of the message's array. The contents of a map or array belong to its item.
std::size_t items_of(const std::vector<Field>& fields) {
  std::int64_t items = 0;
  std::int64_t inner = 0;
  for (const Field& field : fields) {
    items += inner > 0 ? 0 : 1;
    inner -= inner > 0 ? 1 : 0;
    inner += field.type == Field::Type::kMap ? 2 * field.number : 0;
    inner += field.type == Field::Type::kArray ? field.number : 0;
  }
  return static_cast<std::size_t>(items);
}

// Writes the field at `next` with its contents, and advances `next` past it.
void write_all(QCborStreamWriter& writer, const std::vector<Field>& fields, std::size_t& next) {
  const Field& field = fields[next++];
  const bool map = field.type == Field::Type::kMap;
  switch (field.type) {
    case Field::Type::kInteger:
      return writer.append(qint64{field.number});
    case Field::Type::kSingle:
      return writer.append(float_of(field));
    case Field::Type::kBoolean:
      return writer.append(field.number != 0);
    case Field::Type::kText:
      return writer.append(QString::fromStdString(field.text));
    case Field::Type::kMap:
      writer.startMap(static_cast<quint64>(field.number));
      break;
    case Field::Type::kArray:
      writer.startArray(static_cast<quint64>(field.number));
      break;
  }
  for (std::int64_t i = 0; i < (map ? 2 : 1) * field.number; ++i) {
    write_all(writer, fields, next);
  }
  if (map) {
    writer.endMap();
  } else {
    writer.endArray();
  }
}

template <class Message>
Bytes written_by_qt(const Message& message) {
  QByteArray bytes;
  QCborStreamWriter writer(&bytes);
  const std::vector<std::uint64_t> head = head_of(message);
  const std::vector<Field> fields = fields_of(message);
  writer.startArray(head.size() + items_of(fields));
  for (const std::uint64_t number : head) {
    writer.append(quint64{number});
  }
  for (std::size_t next = 0; next < fields.size();) {
    write_all(writer, fields, next);
  }
  writer.endArray();
  return from_qt(bytes);
}

template <class Message>
void expect_we_read_qt(const Message& message) {
  const Bytes bytes = written_by_qt(message);
  EXPECT_EQ(hex(bytes), hex(encoded(message, kSequence)));
  Message back;
  std::uint32_t sequence = 0;
  ASSERT_EQ(decode(bytes.data(), bytes.size(), back, sequence), Decoded::kOk);
  EXPECT_EQ(sequence, kSequence);
  EXPECT_EQ(back.kind, message.kind);
  EXPECT_EQ(fields_of(back), fields_of(message));
}

TEST(QtAgreement, QtWritesTheSameBytesAndTheyAreDecoded) {
  for (const Uplink& message : many_uplinks(kTimes)) {
    expect_we_read_qt(message);
  }
  for (const Downlink& message : many_downlinks(kTimes)) {
    expect_we_read_qt(message);
  }
}

TEST(QtAgreement, FloatsInQtsShortestFormAreRefused) {
  // QCborValue may write 50.0 as a 16-bit float, which the protocol does not allow. Implementations
  // with Qt must select 32 bits.
  Uplink message;
  std::uint32_t sequence = 0;
  const auto bytes = [](QCborValue::EncodingOptions options) {
    return from_qt(QCborValue(QCborArray{5, 0, 0, 0, 50.0}).toCbor(options));
  };
  const Bytes half = bytes(QCborValue::UseFloat16);
  EXPECT_EQ(hex(half), "85 05 00 00 00 f9 52 40");
  EXPECT_EQ(decode(half.data(), half.size(), message, sequence), Decoded::kMalformed);
  const Bytes whole = bytes(QCborValue::NoTransformation);
  EXPECT_EQ(decode(whole.data(), whole.size(), message, sequence), Decoded::kMalformed);
  const Bytes single = bytes(QCborValue::UseFloat);
  EXPECT_EQ(decode(single.data(), single.size(), message, sequence), Decoded::kOk);
  EXPECT_EQ(message.lse.loss_mw, 50.0F);
}

// Bytes that are decoded as a message must be well-formed CBOR of the same length for Qt.
TEST(QtAgreement, BytesThatQtRefusesAreNotDecoded) {
  std::mt19937 random(11);
  int taken = 0;
  const std::vector<Uplink> messages = many_uplinks(20);
  for (int i = 0; i < 200'000; ++i) {
    Bytes bytes = encoded(messages[random() % messages.size()], kSequence);
    for (auto damages = random() % 3 + 1; damages > 0; --damages) {
      bytes[random() % bytes.size()] = static_cast<std::uint8_t>(random());
    }
    Uplink message;
    std::uint32_t sequence = 0;
    if (decode(bytes.data(), bytes.size(), message, sequence) != Decoded::kOk) {
      continue;
    }
    ++taken;
    QCborParserError error;
    (void)QCborValue::fromCbor(to_qt(bytes), &error);
    // Occurs in skipped items, which are well-formed all the same (RFC 8949, §5.3.1).
    if (error.error == QCborError::InvalidUtf8String) {
      continue;
    }
    ASSERT_EQ(error.error, QCborError::NoError) << hex(bytes);
    ASSERT_EQ(error.offset, static_cast<qsizetype>(bytes.size())) << hex(bytes);
  }
  EXPECT_GT(taken, 20'000);  // about a third; otherwise the test has no effect
}

}  // namespace
}  // namespace gs::wire::test
