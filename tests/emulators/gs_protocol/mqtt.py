"""Outlets and centres behind an MQTT 5 broker, with Paho."""
import queue
import socket

import paho.mqtt.client as paho
from paho.mqtt.packettypes import PacketTypes
from paho.mqtt.properties import Properties
from paho.mqtt.reasoncodes import ReasonCodes
from paho.mqtt.subscribeoptions import SubscribeOptions

from .centre import Centre
from .outlet import Outlet
from .serial_line import Station


def properties(packet, **values):
    made = Properties(packet)
    for name, value in values.items():
        setattr(made, name, value)
    return made


class Client(Station):
    """What it receives waits in a queue for turn(), so that only one thread uses outlet or centre."""

    def __init__(self, client_id, port):
        self.port = port
        self.arrived = queue.Queue()
        self.subscribed = 0  # times
        self.client = paho.Client(client_id, protocol=paho.MQTTv5)
        self.client.max_inflight_messages_set(0)  # no limit: the order is kept
        self.client.reconnect_delay_set(1, 1)
        self.client.on_socket_open = self.without_delay
        self.client.on_message = lambda client, data, message: self.arrived.put(message)
        self.client.on_connect = self.on_connect
        self.client.on_subscribe = self.on_subscribe
        self.client.on_disconnect = lambda *_: self.on_disconnect()

    @staticmethod
    def without_delay(client, data, connection):
        connection.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)

    def connect(self, **values):
        self.client.connect("127.0.0.1", self.port, keepalive=self.KEEP_ALIVE_S, clean_start=self.CLEAN_START,
                            properties=properties(PacketTypes.CONNECT, **values))
        self.client.loop_start()
        return self

    def on_connect(self, client, *_):
        self.client.subscribe(self.topics())

    def on_subscribe(self, *_):
        self.subscribed += 1
        self.arrived.put(None)

    def on_disconnect(self):
        """In Paho's thread."""

    def publish(self, topic, payload, qos, retain=False):
        info = self.client.publish(topic, payload, qos, retain)
        return info.rc in (paho.MQTT_ERR_SUCCESS, paho.MQTT_ERR_QUEUE_SIZE)

    def turn(self, timeout_s=0.0):
        try:
            message = self.arrived.get(timeout=timeout_s) if timeout_s else self.arrived.get_nowait()
        except queue.Empty:
            return
        self.take(message)
        while not self.arrived.empty():
            self.take(self.arrived.get())

    def close(self):
        self.client.disconnect()
        self.client.loop_stop()


class MqttOutlet(Client):
    """Paho would send new messages before it repeats those of a broken connection: they are kept."""

    CLEAN_START, KEEP_ALIVE_S = True, 10

    def __init__(self, port, **identity):
        self.ready = False  # the hello of this connection has been sent
        self.kept = []
        self.outlet = Outlet(self.send, **identity)
        self.id = self.outlet.identity["id"]
        self.hello_topic = "gs/%s/hello" % self.id
        super().__init__("%s-%08x" % (self.id, self.outlet.identity["instance"]), port)
        self.client.will_set(self.hello_topic, b"", 1, True)
        self.connect(SessionExpiryInterval=0)

    def topics(self):
        return [("gs/%s/down" % self.id, SubscribeOptions(qos=1, retainHandling=2))]

    def send(self, message, on_hello, sure):
        if on_hello:
            return self.ready and self.publish(self.hello_topic, message, 1, True)
        if not self.ready:
            self.kept += [message] if sure else []
            return sure
        return self.publish("gs/%s/up" % self.id, message, int(sure))

    def on_disconnect(self):
        self.ready = False

    def take(self, message):
        if message is None:
            self.ready = True
            self.outlet.say_hello()
            kept, self.kept = self.kept, []
            for one in kept:
                self.send(one, False, True)
        else:
            self.outlet.receive(message.payload)

    def depart_with_will(self):
        self.client.disconnect(reasoncode=ReasonCodes(PacketTypes.DISCONNECT, "Disconnect with will message"))
        self.client.loop_stop()

    def depart(self):
        self.client.publish(self.hello_topic, b"", 1, True).wait_for_publish(10)
        self.close()

    def break_connection(self):
        """As a lost network: no DISCONNECT, and no new connection."""
        self.client.loop_stop()
        self.client.socket().close()


class MqttCentre(Client):
    CLEAN_START, KEEP_ALIVE_S = False, 30

    def __init__(self, port, client_id, session=None, expiry_s=60):
        self.centre = Centre(self.send, session=session)
        super().__init__(client_id, port)
        self.connect(SessionExpiryInterval=expiry_s, ReceiveMaximum=65535)

    def topics(self):
        return [("gs/+/hello", SubscribeOptions(qos=1)), ("gs/+/up", SubscribeOptions(qos=1))]

    def send(self, outlet, message):
        return self.publish("gs/%s/down" % outlet, message, 1)

    def take(self, message):
        if message is not None and self.passes(message.payload):
            _, outlet, topic = message.topic.split("/")
            self.centre.receive(outlet, message.payload, topic == "hello", bool(message.retain))

