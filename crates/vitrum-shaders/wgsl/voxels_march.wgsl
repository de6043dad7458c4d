struct type_2 {
member: u32,
member_1: u32,
member_2: u32,
}
struct type_4 {
member: f32,
member_1: f32,
member_2: f32,
member_3: u32,
}
struct type_5 {
member: f32,
member_1: f32,
member_2: f32,
}
struct type_6 {
member: u32,
member_1: u32,
member_2: u32,
member_3: u32,
member_4: type_5,
member_5: type_5,
member_6: type_5,
member_7: type_5,
member_8: type_5,
member_9: type_5,
member_10: f32,
member_11: f32,
member_12: f32,
}
struct type_7 {
member: type_5,
member_1: f32,
}
struct type_8 {
member: type_7,
member_1: type_5,
}
struct type_9 {
member: type_8,
member_1: type_8,
}
struct type_10 {
member: type_5,
member_1: type_5,
member_2: f32,
member_3: f32,
member_4: u32,
member_5: u32,
member_6: u32,
}
struct type_11 {
member: u32,
member_1: type_5,
member_2: type_5,
member_3: type_5,
member_4: type_10,
}
struct type_12 {
member: type_5,
member_1: type_5,
member_2: type_5,
member_3: type_5,
member_4: type_5,
member_5: type_5,
member_6: type_5,
member_7: type_5,
member_8: type_5,
member_9: type_5,
}
struct type_13 {
member: type_2,
member_1: u32,
member_2: type_5,
member_3: type_7,
member_4: type_7,
member_5: type_7,
member_6: type_7,
member_7: type_5,
member_8: f32,
member_9: f32,
member_10: f32,
member_11: u32,
member_12: u32,
member_13: u32,
}
struct type_14 {
member: u32,
member_1: u32,
}
struct type_15 {
member: type_14,
member_1: f32,
member_2: f32,
member_3: u32,
member_4: u32,
}
struct type_16 {
member: type_5,
member_1: f32,
member_2: f32,
}
struct type_17 {
member: type_7,
member_1: type_7,
member_2: type_7,
member_3: u32,
member_4: type_14,
member_5: f32,
member_6: f32,
member_7: f32,
member_8: f32,
member_9: f32,
member_10: f32,
member_11: f32,
member_12: u32,
member_13: u32,
member_14: type_2,
member_15: u32,
member_16: u32,
member_17: type_14,
member_18: type_15,
member_19: type_5,
member_20: type_16,
member_21: f32,
member_22: f32,
member_23: f32,
member_24: f32,
}
struct type_18 {
member: type_2,
member_1: u32,
member_2: type_2,
member_3: u32,
member_4: type_2,
member_5: u32,
member_6: type_4,
member_7: type_5,
member_8: type_5,
member_9: type_5,
member_10: type_5,
member_11: f32,
member_12: f32,
member_13: f32,
member_14: type_5,
member_15: type_5,
member_16: type_6,
member_17: type_5,
member_18: type_9,
member_19: type_11,
member_20: type_12,
member_21: type_13,
member_22: type_17,
}
struct type_19 {
member: type_18,
}
struct type_21 {
member: array<f32>,
}
struct type_25 {
member: vec3<f32>,
member_1: vec3<f32>,
member_2: vec3<f32>,
member_3: vec3<f32>,
member_4: vec3<f32>,
member_5: f32,
member_6: f32,
member_7: i32,
member_8: f32,
member_9: f32,
member_10: f32,
member_11: f32,
member_12: vec3<f32>,
member_13: vec3<f32>,
member_14: i32,
member_15: i32,
member_16: i32,
member_17: f32,
}
struct type_27 {
member: array<u32>,
}
struct type_28 {
member: vec3<f32>,
member_1: f32,
}
struct type_31 {
member: array<atomic<u32>>,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_19;
@group(0) @binding(3)
var<storage> global_2: type_21;
@group(0) @binding(4)
var<storage, read_write> global_3: type_21;
@group(0) @binding(1)
var<storage> global_4: type_27;
@group(0) @binding(2)
var<storage> global_5: type_27;
@group(0) @binding(5)
var<storage, read_write> global_6: type_31;
fn function_() {
var local: i32;
var local_1: vec3<f32>;
var local_2: i32;
var local_3: vec3<f32>;
var local_4: i32;
var local_5: vec3<f32>;
var phi_807_: u32;
var phi_903_: i32;
var phi_906_: i32;
var phi_1342_: f32;
var phi_904_: i32;
var phi_907_: i32;
var local_6: i32;
var phi_1350_: type_25;
var phi_1352_: type_25;
var phi_1355_: i32;
var phi_1691_: f32;
var phi_1729_: i32;
var phi_1732_: i32;
var phi_2168_: f32;
var phi_1730_: i32;
var phi_1733_: i32;
var local_7: i32;
var phi_2180_: i32;
var phi_2183_: f32;
var phi_2185_: f32;
var phi_2214_: i32;
var phi_2217_: i32;
var phi_2653_: f32;
var phi_2215_: i32;
var phi_2218_: i32;
var local_8: i32;
var phi_2181_: i32;
var phi_2184_: f32;
var phi_2186_: f32;
var local_9: f32;
var local_10: f32;
var local_11: f32;
var phi_2688_: i32;
var phi_2691_: i32;
var phi_3127_: f32;
var phi_2689_: i32;
var phi_2692_: i32;
var local_12: i32;
var local_13: i32;
var phi_3587_: f32;
var phi_4026_: f32;
var phi_4466_: f32;
var phi_4905_: f32;
var phi_5345_: f32;
var phi_5784_: f32;
var phi_5847_: vec3<f32>;
var phi_5894_: f32;
var phi_5897_: f32;
var phi_5899_: i32;
var phi_5901_: f32;
var phi_5903_: type_28;
var phi_6375_: f32;
var phi_6814_: f32;
var phi_7254_: f32;
var phi_7693_: f32;
var phi_8133_: f32;
var phi_8572_: f32;
var phi_9006_: f32;
var phi_9476_: f32;
var phi_9915_: f32;
var phi_10355_: f32;
var phi_10794_: f32;
var phi_11234_: f32;
var phi_11673_: f32;
var phi_12128_: f32;
var phi_12200_: type_28;
var phi_5895_: f32;
var phi_5898_: f32;
var phi_5900_: i32;
var phi_5902_: f32;
var phi_5904_: type_28;
var phi_12206_: type_28;
var local_14: f32;
var local_15: i32;
var local_16: f32;
var phi_12520_: type_25;
var local_17: i32;
var local_18: i32;
var phi_12743_: type_25;
var phi_13141_: i32;
var phi_13143_: i32;
var phi_13171_: type_25;
var phi_13172_: type_25;
var phi_13258_: type_25;
var phi_13259_: type_25;
var phi_13277_: type_25;
var local_19: i32;
var phi_13725_: type_25;
var phi_13726_: type_25;
var phi_13704_: type_25;
var phi_13727_: type_25;
var local_20: i32;
var phi_13735_: type_25;
var phi_13736_: type_25;
var phi_13737_: bool;
var phi_14316_: type_25;
var local_21: i32;
var phi_14618_: type_25;
var phi_14619_: type_25;
var phi_14620_: type_25;
var phi_14027_: type_25;
var phi_14621_: type_25;
var phi_1353_: type_25;
var phi_1356_: i32;
var local_22: type_25;
var local_23: type_25;
var local_24: type_25;
var local_25: type_25;
var local_26: type_25;
var local_27: type_25;
var local_28: type_25;
var local_29: type_25;
var local_30: type_25;
var local_31: type_25;
var local_32: type_25;
var local_33: type_25;
var local_34: type_25;
var local_35: type_25;
var local_36: type_25;
var local_37: type_25;
var local_38: type_25;
var local_39: type_25;
var local_40: type_25;
var local_41: type_25;
var local_42: type_25;
var local_43: type_25;
var local_44: type_25;
var local_45: type_25;
var local_46: type_25;
var local_47: type_25;
var local_48: type_25;
var local_49: type_25;
var local_50: type_25;
var local_51: type_25;
var local_52: type_25;
var local_53: f32;
var local_54: type_28;
let _e110 = global;
let _e116 = arrayLength((&global_5.member));
let _e118 = arrayLength((&global_2.member));
let _e125 = global_1.member.member;
if (_e110.x < _e125.member) {
if (_e110.y < _e125.member_1) {
let _e132 = (_e125.member * _e125.member_1);
let _e134 = ((_e110.y * _e125.member) + _e110.x);
let _e135 = bitcast<i32>(_e134);
let _e137 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e139 = select(_e137, _e135, (_e135 < _e137));
let _e145 = global_3.member[bitcast<u32>(select(0i, _e139, (_e139 > 0i)))];
let _e146 = (_e132 + _e134);
let _e147 = bitcast<i32>(_e146);
let _e149 = select(_e137, _e147, (_e147 < _e137));
let _e155 = global_3.member[bitcast<u32>(select(0i, _e149, (_e149 > 0i)))];
let _e157 = ((2u * _e132) + _e134);
let _e158 = bitcast<i32>(_e157);
let _e160 = select(_e137, _e158, (_e158 < _e137));
let _e166 = global_3.member[bitcast<u32>(select(0i, _e160, (_e160 > 0i)))];
let _e168 = ((3u * _e132) + _e134);
let _e169 = bitcast<i32>(_e168);
let _e171 = select(_e137, _e169, (_e169 < _e137));
let _e177 = global_3.member[bitcast<u32>(select(0i, _e171, (_e171 > 0i)))];
let _e179 = ((4u * _e132) + _e134);
let _e180 = bitcast<i32>(_e179);
let _e182 = select(_e137, _e180, (_e180 < _e137));
let _e188 = global_3.member[bitcast<u32>(select(0i, _e182, (_e182 > 0i)))];
let _e190 = ((5u * _e132) + _e134);
let _e191 = bitcast<i32>(_e190);
let _e193 = select(_e137, _e191, (_e191 < _e137));
let _e199 = global_3.member[bitcast<u32>(select(0i, _e193, (_e193 > 0i)))];
let _e201 = ((6u * _e132) + _e134);
let _e202 = bitcast<i32>(_e201);
let _e204 = select(_e137, _e202, (_e202 < _e137));
let _e210 = global_3.member[bitcast<u32>(select(0i, _e204, (_e204 > 0i)))];
let _e212 = ((7u * _e132) + _e134);
let _e213 = bitcast<i32>(_e212);
let _e215 = select(_e137, _e213, (_e213 < _e137));
let _e221 = global_3.member[bitcast<u32>(select(0i, _e215, (_e215 > 0i)))];
let _e223 = ((8u * _e132) + _e134);
let _e224 = bitcast<i32>(_e223);
let _e226 = select(_e137, _e224, (_e224 < _e137));
let _e232 = global_3.member[bitcast<u32>(select(0i, _e226, (_e226 > 0i)))];
let _e234 = ((9u * _e132) + _e134);
let _e235 = bitcast<i32>(_e234);
let _e237 = select(_e137, _e235, (_e235 < _e137));
let _e243 = global_3.member[bitcast<u32>(select(0i, _e237, (_e237 > 0i)))];
let _e245 = ((10u * _e132) + _e134);
let _e246 = bitcast<i32>(_e245);
let _e248 = select(_e137, _e246, (_e246 < _e137));
let _e254 = global_3.member[bitcast<u32>(select(0i, _e248, (_e248 > 0i)))];
let _e256 = ((11u * _e132) + _e134);
let _e257 = bitcast<i32>(_e256);
let _e259 = select(_e137, _e257, (_e257 < _e137));
let _e265 = global_3.member[bitcast<u32>(select(0i, _e259, (_e259 > 0i)))];
let _e267 = ((12u * _e132) + _e134);
let _e268 = bitcast<i32>(_e267);
let _e270 = select(_e137, _e268, (_e268 < _e137));
let _e276 = global_3.member[bitcast<u32>(select(0i, _e270, (_e270 > 0i)))];
let _e278 = ((13u * _e132) + _e134);
let _e279 = bitcast<i32>(_e278);
let _e281 = select(_e137, _e279, (_e279 < _e137));
let _e287 = global_3.member[bitcast<u32>(select(0i, _e281, (_e281 > 0i)))];
let _e289 = ((14u * _e132) + _e134);
let _e290 = bitcast<i32>(_e289);
let _e292 = select(_e137, _e290, (_e290 < _e137));
let _e298 = global_3.member[bitcast<u32>(select(0i, _e292, (_e292 > 0i)))];
let _e300 = ((15u * _e132) + _e134);
let _e301 = bitcast<i32>(_e300);
let _e303 = select(_e137, _e301, (_e301 < _e137));
let _e309 = global_3.member[bitcast<u32>(select(0i, _e303, (_e303 > 0i)))];
let _e311 = ((16u * _e132) + _e134);
let _e312 = bitcast<i32>(_e311);
let _e314 = select(_e137, _e312, (_e312 < _e137));
let _e320 = global_3.member[bitcast<u32>(select(0i, _e314, (_e314 > 0i)))];
let _e322 = ((17u * _e132) + _e134);
let _e323 = bitcast<i32>(_e322);
let _e325 = select(_e137, _e323, (_e323 < _e137));
let _e331 = global_3.member[bitcast<u32>(select(0i, _e325, (_e325 > 0i)))];
let _e333 = ((18u * _e132) + _e134);
let _e334 = bitcast<i32>(_e333);
let _e336 = select(_e137, _e334, (_e334 < _e137));
let _e342 = global_3.member[bitcast<u32>(select(0i, _e336, (_e336 > 0i)))];
let _e344 = ((19u * _e132) + _e134);
let _e345 = bitcast<i32>(_e344);
let _e347 = select(_e137, _e345, (_e345 < _e137));
let _e353 = global_3.member[bitcast<u32>(select(0i, _e347, (_e347 > 0i)))];
let _e355 = ((20u * _e132) + _e134);
let _e356 = bitcast<i32>(_e355);
let _e358 = select(_e137, _e356, (_e356 < _e137));
let _e364 = global_3.member[bitcast<u32>(select(0i, _e358, (_e358 > 0i)))];
let _e366 = ((21u * _e132) + _e134);
let _e367 = bitcast<i32>(_e366);
let _e369 = select(_e137, _e367, (_e367 < _e137));
let _e375 = global_3.member[bitcast<u32>(select(0i, _e369, (_e369 > 0i)))];
let _e377 = ((22u * _e132) + _e134);
let _e378 = bitcast<i32>(_e377);
let _e380 = select(_e137, _e378, (_e378 < _e137));
let _e386 = global_3.member[bitcast<u32>(select(0i, _e380, (_e380 > 0i)))];
let _e388 = ((23u * _e132) + _e134);
let _e389 = bitcast<i32>(_e388);
let _e391 = select(_e137, _e389, (_e389 < _e137));
let _e397 = global_3.member[bitcast<u32>(select(0i, _e391, (_e391 > 0i)))];
let _e399 = ((24u * _e132) + _e134);
let _e400 = bitcast<i32>(_e399);
let _e402 = select(_e137, _e400, (_e400 < _e137));
let _e408 = global_3.member[bitcast<u32>(select(0i, _e402, (_e402 > 0i)))];
let _e410 = ((25u * _e132) + _e134);
let _e411 = bitcast<i32>(_e410);
let _e413 = select(_e137, _e411, (_e411 < _e137));
let _e419 = global_3.member[bitcast<u32>(select(0i, _e413, (_e413 > 0i)))];
let _e421 = ((26u * _e132) + _e134);
let _e422 = bitcast<i32>(_e421);
let _e424 = select(_e137, _e422, (_e422 < _e137));
let _e430 = global_3.member[bitcast<u32>(select(0i, _e424, (_e424 > 0i)))];
let _e432 = ((27u * _e132) + _e134);
let _e433 = bitcast<i32>(_e432);
let _e435 = select(_e137, _e433, (_e433 < _e137));
let _e441 = global_3.member[bitcast<u32>(select(0i, _e435, (_e435 > 0i)))];
let _e443 = ((28u * _e132) + _e134);
let _e444 = bitcast<i32>(_e443);
let _e446 = select(_e137, _e444, (_e444 < _e137));
let _e452 = global_3.member[bitcast<u32>(select(0i, _e446, (_e446 > 0i)))];
let _e454 = ((29u * _e132) + _e134);
let _e455 = bitcast<i32>(_e454);
let _e457 = select(_e137, _e455, (_e455 < _e137));
let _e463 = global_3.member[bitcast<u32>(select(0i, _e457, (_e457 > 0i)))];
let _e465 = ((30u * _e132) + _e134);
let _e466 = bitcast<i32>(_e465);
let _e468 = select(_e137, _e466, (_e466 < _e137));
let _e474 = global_3.member[bitcast<u32>(select(0i, _e468, (_e468 > 0i)))];
let _e476 = ((31u * _e132) + _e134);
let _e477 = bitcast<i32>(_e476);
let _e479 = select(_e137, _e477, (_e477 < _e137));
let _e485 = global_3.member[bitcast<u32>(select(0i, _e479, (_e479 > 0i)))];
let _e486 = (_e320 == 0f);
if _e486 {
phi_807_ = 3u;
} else {
phi_807_ = select(0u, 1u, (_e320 == 4f));
}
let _e490 = phi_807_;
if (_e490 > 0u) {
if (arrayLength((&global_6.member)) >= 3u) {
let _e499 = atomicLoad((&global_6.member[0u]));
if (_e499 == 0u) {
atomicStore((&global_6.member[0u]), ((_e125.member + 7u) / 8u));
atomicStore((&global_6.member[1u]), ((_e125.member_1 + 7u) / 8u));
atomicStore((&global_6.member[2u]), 1u);
}
}
}
if (_e490 > 1u) {
let _e507 = vec3<f32>(_e145, _e155, _e166);
let _e508 = vec3<f32>(_e177, _e188, _e199);
let _e509 = vec3<f32>(_e210, _e221, _e232);
let _e510 = vec3<f32>(_e243, _e254, _e265);
let _e511 = vec3<f32>(_e276, _e287, _e298);
let _e519 = vec3<f32>(_e386, _e397, _e408);
let _e520 = vec3<f32>(_e419, _e430, _e441);
let _e527 = select(0i, select(select(i32(_e452), i32(-2147483648), (_e452 < -2147483600f)), 2147483647i, (_e452 > 2147483500f)), (_e452 == _e452));
let _e534 = select(0i, select(select(i32(_e463), i32(-2147483648), (_e463 < -2147483600f)), 2147483647i, (_e463 > 2147483500f)), (_e463 == _e463));
let _e541 = select(0i, select(select(i32(_e474), i32(-2147483648), (_e474 < -2147483600f)), 2147483647i, (_e474 > 2147483500f)), (_e474 == _e474));
let _e545 = global_1.member.member_14;
let _e551 = global_1.member.member_15;
if (_e486 && (_e342 == 0f)) {
let _e559 = global_1.member.member_3;
phi_903_ = (bitcast<i32>(_e559) - 1i);
phi_906_ = 16i;
loop {
let _e563 = phi_903_;
let _e565 = phi_906_;
local_6 = _e565;
let _e566 = (_e563 >= 0i);
if _e566 {
let _e570 = global_1.member.member_2.member;
let _e575 = global_1.member.member_2.member_1;
let _e580 = global_1.member.member_2.member_2;
let _e582 = (_e145 - 0.5f);
let _e583 = (_e155 - 0.5f);
let _e584 = (_e166 - 0.5f);
let _e586 = f32((bitcast<i32>(_e570) - 2i));
let _e588 = select(0f, _e582, (_e582 > 0f));
let _e590 = select(_e586, _e588, (_e588 < _e586));
let _e597 = select(0i, select(select(i32(_e590), i32(-2147483648), (_e590 < -2147483600f)), 2147483647i, (_e590 > 2147483500f)), (_e590 == _e590));
let _e601 = (_e597 - select(0i, 1i, (_e590 < f32(_e597))));
let _e603 = f32((bitcast<i32>(_e575) - 2i));
let _e605 = select(0f, _e583, (_e583 > 0f));
let _e607 = select(_e603, _e605, (_e605 < _e603));
let _e614 = select(0i, select(select(i32(_e607), i32(-2147483648), (_e607 < -2147483600f)), 2147483647i, (_e607 > 2147483500f)), (_e607 == _e607));
let _e618 = (_e614 - select(0i, 1i, (_e607 < f32(_e614))));
let _e620 = f32((bitcast<i32>(_e580) - 2i));
let _e622 = select(0f, _e584, (_e584 > 0f));
let _e624 = select(_e620, _e622, (_e622 < _e620));
let _e631 = select(0i, select(select(i32(_e624), i32(-2147483648), (_e624 < -2147483600f)), 2147483647i, (_e624 > 2147483500f)), (_e624 == _e624));
let _e635 = (_e631 - select(0i, 1i, (_e624 < f32(_e631))));
let _e636 = (_e563 * 4i);
let _e637 = (_e636 + 1i);
let _e639 = (bitcast<i32>(_e116) - 1i);
let _e641 = select(_e639, _e637, (_e637 < _e639));
let _e647 = global_5.member[bitcast<u32>(select(0i, _e641, (_e641 > 0i)))];
let _e648 = (_e636 + 2i);
let _e650 = select(_e639, _e648, (_e648 < _e639));
let _e656 = global_5.member[bitcast<u32>(select(0i, _e650, (_e650 > 0i)))];
let _e657 = (_e636 + 3i);
let _e659 = select(_e639, _e657, (_e657 < _e639));
let _e665 = global_5.member[bitcast<u32>(select(0i, _e659, (_e659 > 0i)))];
let _e668 = (_e601 - bitcast<i32>((_e647 & 65535u)));
let _e673 = bitcast<i32>((_e647 >> bitcast<u32>(16i)));
let _e678 = (_e618 - bitcast<i32>((_e656 & 65535u)));
let _e683 = bitcast<i32>((_e656 >> bitcast<u32>(16i)));
let _e688 = (_e635 - bitcast<i32>((_e665 & 65535u)));
if ((((_e668 >= 0i) && ((_e668 + 1i) < _e673)) && ((_e678 >= 0i) && ((_e678 + 1i) < _e683))) && ((_e688 >= 0i) && ((_e688 + 1i) < bitcast<i32>((_e665 >> bitcast<u32>(16i)))))) {
let _e698 = (_e683 * _e673);
let _e700 = select(_e639, _e636, (_e636 < _e639));
let _e706 = global_5.member[bitcast<u32>(select(0i, _e700, (_e700 > 0i)))];
let _e712 = (((bitcast<i32>(_e706) + (_e688 * _e698)) + (_e678 * _e673)) + _e668);
let _e714 = (_e582 - f32(_e601));
let _e716 = (_e583 - f32(_e618));
let _e719 = (2i * _e712);
let _e721 = (_e719 >> bitcast<u32>(2i));
let _e724 = bitcast<u32>(((_e719 & 3i) * 8i));
let _e726 = select(_e639, _e721, (_e721 < _e639));
let _e732 = global_5.member[bitcast<u32>(select(0i, _e726, (_e726 > 0i)))];
let _e736 = (_e721 + 1i);
let _e738 = select(_e639, _e736, (_e736 < _e639));
let _e744 = global_5.member[bitcast<u32>(select(0i, _e738, (_e738 > 0i)))];
let _e751 = ((_e732 >> bitcast<u32>((_e724 & 31u))) | ((_e744 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e724) & 31u))));
let _e754 = f32(bitcast<i32>((_e751 & 65535u)));
let _e761 = (_e754 + ((f32(bitcast<i32>((_e751 >> bitcast<u32>(16i)))) - _e754) * _e714));
let _e763 = (2i * (_e712 + _e673));
let _e765 = (_e763 >> bitcast<u32>(2i));
let _e768 = bitcast<u32>(((_e763 & 3i) * 8i));
let _e770 = select(_e639, _e765, (_e765 < _e639));
let _e776 = global_5.member[bitcast<u32>(select(0i, _e770, (_e770 > 0i)))];
let _e780 = (_e765 + 1i);
let _e782 = select(_e639, _e780, (_e780 < _e639));
let _e788 = global_5.member[bitcast<u32>(select(0i, _e782, (_e782 > 0i)))];
let _e795 = ((_e776 >> bitcast<u32>((_e768 & 31u))) | ((_e788 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e768) & 31u))));
let _e798 = f32(bitcast<i32>((_e795 & 65535u)));
let _e806 = (_e712 + _e698);
let _e807 = (2i * _e806);
let _e809 = (_e807 >> bitcast<u32>(2i));
let _e812 = bitcast<u32>(((_e807 & 3i) * 8i));
let _e814 = select(_e639, _e809, (_e809 < _e639));
let _e820 = global_5.member[bitcast<u32>(select(0i, _e814, (_e814 > 0i)))];
let _e824 = (_e809 + 1i);
let _e826 = select(_e639, _e824, (_e824 < _e639));
let _e832 = global_5.member[bitcast<u32>(select(0i, _e826, (_e826 > 0i)))];
let _e839 = ((_e820 >> bitcast<u32>((_e812 & 31u))) | ((_e832 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e812) & 31u))));
let _e842 = f32(bitcast<i32>((_e839 & 65535u)));
let _e849 = (_e842 + ((f32(bitcast<i32>((_e839 >> bitcast<u32>(16i)))) - _e842) * _e714));
let _e851 = (2i * (_e806 + _e673));
let _e853 = (_e851 >> bitcast<u32>(2i));
let _e856 = bitcast<u32>(((_e851 & 3i) * 8i));
let _e858 = select(_e639, _e853, (_e853 < _e639));
let _e864 = global_5.member[bitcast<u32>(select(0i, _e858, (_e858 > 0i)))];
let _e868 = (_e853 + 1i);
let _e870 = select(_e639, _e868, (_e868 < _e639));
let _e876 = global_5.member[bitcast<u32>(select(0i, _e870, (_e870 > 0i)))];
let _e883 = ((_e864 >> bitcast<u32>((_e856 & 31u))) | ((_e876 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e856) & 31u))));
let _e886 = f32(bitcast<i32>((_e883 & 65535u)));
let _e896 = (_e761 + (((_e798 + ((f32(bitcast<i32>((_e795 >> bitcast<u32>(16i)))) - _e798) * _e714)) - _e761) * _e716));
phi_1342_ = (_e896 + (((_e849 + (((_e886 + ((f32(bitcast<i32>((_e883 >> bitcast<u32>(16i)))) - _e886) * _e714)) - _e849) * _e716)) - _e896) * (_e584 - f32(_e635))));
} else {
phi_1342_ = 0f;
}
let _e904 = phi_1342_;
phi_904_ = (_e563 - 1i);
phi_907_ = select(_e565, _e563, (_e904 > 32767.5f));
} else {
phi_904_ = i32();
phi_907_ = i32();
}
let _e909 = phi_904_;
let _e911 = phi_907_;
continue;
continuing {
phi_903_ = _e909;
phi_906_ = _e911;
break if !(_e566);
}
}
let _e914 = local_6;
phi_1350_ = type_25(_e507, _e508, _e509, _e510, _e511, _e309, _e320, _e914, _e342, _e353, _e364, _e375, _e519, _e520, _e527, _e534, _e541, _e485);
} else {
phi_1350_ = type_25(_e507, _e508, _e509, _e510, _e511, _e309, _e320, select(0i, select(select(i32(_e331), i32(-2147483648), (_e331 < -2147483600f)), 2147483647i, (_e331 > 2147483500f)), (_e331 == _e331)), _e342, _e353, _e364, _e375, _e519, _e520, _e527, _e534, _e541, _e485);
}
let _e917 = phi_1350_;
phi_1352_ = _e917;
phi_1355_ = 0i;
loop {
let _e919 = phi_1352_;
let _e921 = phi_1355_;
local_22 = _e919;
local_23 = _e919;
local_24 = _e919;
local_25 = _e919;
local_26 = _e919;
local_27 = _e919;
local_28 = _e919;
local_29 = _e919;
local_30 = _e919;
local_31 = _e919;
local_32 = _e919;
local_33 = _e919;
local_34 = _e919;
local_35 = _e919;
local_36 = _e919;
local_37 = _e919;
local_38 = _e919;
local_39 = _e919;
local_40 = _e919;
local_41 = _e919;
local_42 = _e919;
local_43 = _e919;
local_44 = _e919;
local_45 = _e919;
local_46 = _e919;
local_47 = _e919;
local_48 = _e919;
local_49 = _e919;
local_50 = _e919;
local_51 = _e919;
local_52 = _e919;
let _e925 = ((_e921 < 256i) && (_e919.member_6 == 0f));
local_53 = _e919.member_6;
if _e925 {
let _e936 = (1f / select(_e919.member_1.x, select(1e-12f, -1e-12f, (_e919.member_1.x < 0f)), (bitcast<f32>((bitcast<u32>(_e919.member_1.x) & 2147483647u)) < 1e-12f)));
let _e945 = (1f / select(_e919.member_1.y, select(1e-12f, -1e-12f, (_e919.member_1.y < 0f)), (bitcast<f32>((bitcast<u32>(_e919.member_1.y) & 2147483647u)) < 1e-12f)));
let _e954 = (1f / select(_e919.member_1.z, select(1e-12f, -1e-12f, (_e919.member_1.z < 0f)), (bitcast<f32>((bitcast<u32>(_e919.member_1.z) & 2147483647u)) < 1e-12f)));
let _e958 = ((_e545.member - _e919.member.x) * _e936);
let _e960 = ((_e551.member - _e919.member.x) * _e936);
let _e963 = ((_e545.member_1 - _e919.member.y) * _e945);
let _e965 = ((_e551.member_1 - _e919.member.y) * _e945);
let _e968 = ((_e545.member_2 - _e919.member.z) * _e954);
let _e970 = ((_e551.member_2 - _e919.member.z) * _e954);
let _e972 = select(_e960, _e958, (_e958 > _e960));
let _e974 = select(_e965, _e963, (_e963 > _e965));
let _e976 = select(_e974, _e972, (_e972 < _e974));
let _e978 = select(_e970, _e968, (_e968 > _e970));
let _e980 = select(_e978, _e976, (_e976 < _e978));
let _e984 = global_1.member.member_4.member;
let _e985 = bitcast<i32>(_e984);
let _e989 = global_1.member.member_4.member_1;
let _e990 = bitcast<i32>(_e989);
let _e994 = global_1.member.member_4.member_2;
let _e997 = ((_e919.member.x - 0.5f) / 4f);
let _e999 = f32((_e985 - 1i));
let _e1001 = select(0f, _e997, (_e997 > 0f));
let _e1003 = select(_e999, _e1001, (_e1001 < _e999));
let _e1010 = select(0i, select(select(i32(_e1003), i32(-2147483648), (_e1003 < -2147483600f)), 2147483647i, (_e1003 > 2147483500f)), (_e1003 == _e1003));
let _e1014 = (_e1010 - select(0i, 1i, (_e1003 < f32(_e1010))));
let _e1016 = ((_e919.member.y - 0.5f) / 4f);
let _e1018 = f32((_e990 - 1i));
let _e1020 = select(0f, _e1016, (_e1016 > 0f));
let _e1022 = select(_e1018, _e1020, (_e1020 < _e1018));
let _e1029 = select(0i, select(select(i32(_e1022), i32(-2147483648), (_e1022 < -2147483600f)), 2147483647i, (_e1022 > 2147483500f)), (_e1022 == _e1022));
let _e1033 = (_e1029 - select(0i, 1i, (_e1022 < f32(_e1029))));
let _e1035 = ((_e919.member.z - 0.5f) / 4f);
let _e1037 = f32((bitcast<i32>(_e994) - 1i));
let _e1039 = select(0f, _e1035, (_e1035 > 0f));
let _e1041 = select(_e1037, _e1039, (_e1039 < _e1037));
let _e1048 = select(0i, select(select(i32(_e1041), i32(-2147483648), (_e1041 < -2147483600f)), 2147483647i, (_e1041 > 2147483500f)), (_e1041 == _e1041));
let _e1052 = (_e1048 - select(0i, 1i, (_e1041 < f32(_e1048))));
let _e1056 = ((((_e1052 * _e990) + _e1033) * _e985) + _e1014);
let _e1058 = (bitcast<i32>(arrayLength((&global_4.member))) - 1i);
let _e1060 = select(_e1058, _e1056, (_e1056 < _e1058));
let _e1066 = global_4.member[bitcast<u32>(select(0i, _e1060, (_e1060 > 0i)))];
let _e1067 = bitcast<i32>(_e1066);
if (_e1067 > 0i) {
let _e1097 = ((((f32(((_e1014 - _e1067) + 1i)) * 4f) + 0.5f) - _e919.member.x) * _e936);
let _e1099 = ((((f32((_e1014 + _e1067)) * 4f) + 0.5f) - _e919.member.x) * _e936);
let _e1101 = ((((f32(((_e1033 - _e1067) + 1i)) * 4f) + 0.5f) - _e919.member.y) * _e945);
let _e1103 = ((((f32((_e1033 + _e1067)) * 4f) + 0.5f) - _e919.member.y) * _e945);
let _e1105 = ((((f32(((_e1052 - _e1067) + 1i)) * 4f) + 0.5f) - _e919.member.z) * _e954);
let _e1107 = ((((f32((_e1052 + _e1067)) * 4f) + 0.5f) - _e919.member.z) * _e954);
let _e1109 = select(_e1099, _e1097, (_e1097 > _e1099));
let _e1111 = select(_e1103, _e1101, (_e1101 > _e1103));
let _e1113 = select(_e1111, _e1109, (_e1109 < _e1111));
let _e1115 = select(_e1107, _e1105, (_e1105 > _e1107));
let _e1117 = select(_e1115, _e1113, (_e1113 < _e1115));
phi_1691_ = (select(0f, _e1117, (_e1117 > 0f)) + 1e-3f);
} else {
phi_1691_ = 0.5f;
}
let _e1122 = phi_1691_;
let _e1125 = (select(0f, _e980, (_e980 > 0f)) + 1e-3f);
let _e1127 = select(_e1125, _e1122, (_e1122 < _e1125));
let _e1129 = (_e919.member_17 <= _e1127);
let _e1130 = select(_e1127, _e919.member_17, _e1129);
let _e1140 = global_1.member.member_3;
let _e1142 = (bitcast<i32>(_e1140) - 1i);
phi_1729_ = _e1142;
phi_1732_ = 16i;
loop {
let _e1144 = phi_1729_;
let _e1146 = phi_1732_;
local_7 = _e1146;
local_21 = _e1146;
let _e1147 = (_e1144 >= 0i);
if _e1147 {
let _e1151 = global_1.member.member_2.member;
let _e1156 = global_1.member.member_2.member_1;
let _e1161 = global_1.member.member_2.member_2;
let _e1163 = ((_e919.member.x + (_e919.member_1.x * _e1130)) - 0.5f);
let _e1164 = ((_e919.member.y + (_e919.member_1.y * _e1130)) - 0.5f);
let _e1165 = ((_e919.member.z + (_e919.member_1.z * _e1130)) - 0.5f);
let _e1167 = f32((bitcast<i32>(_e1151) - 2i));
let _e1169 = select(0f, _e1163, (_e1163 > 0f));
let _e1171 = select(_e1167, _e1169, (_e1169 < _e1167));
let _e1178 = select(0i, select(select(i32(_e1171), i32(-2147483648), (_e1171 < -2147483600f)), 2147483647i, (_e1171 > 2147483500f)), (_e1171 == _e1171));
let _e1182 = (_e1178 - select(0i, 1i, (_e1171 < f32(_e1178))));
let _e1184 = f32((bitcast<i32>(_e1156) - 2i));
let _e1186 = select(0f, _e1164, (_e1164 > 0f));
let _e1188 = select(_e1184, _e1186, (_e1186 < _e1184));
let _e1195 = select(0i, select(select(i32(_e1188), i32(-2147483648), (_e1188 < -2147483600f)), 2147483647i, (_e1188 > 2147483500f)), (_e1188 == _e1188));
let _e1199 = (_e1195 - select(0i, 1i, (_e1188 < f32(_e1195))));
let _e1201 = f32((bitcast<i32>(_e1161) - 2i));
let _e1203 = select(0f, _e1165, (_e1165 > 0f));
let _e1205 = select(_e1201, _e1203, (_e1203 < _e1201));
let _e1212 = select(0i, select(select(i32(_e1205), i32(-2147483648), (_e1205 < -2147483600f)), 2147483647i, (_e1205 > 2147483500f)), (_e1205 == _e1205));
let _e1216 = (_e1212 - select(0i, 1i, (_e1205 < f32(_e1212))));
let _e1217 = (_e1144 * 4i);
let _e1218 = (_e1217 + 1i);
let _e1220 = (bitcast<i32>(_e116) - 1i);
let _e1222 = select(_e1220, _e1218, (_e1218 < _e1220));
let _e1228 = global_5.member[bitcast<u32>(select(0i, _e1222, (_e1222 > 0i)))];
let _e1229 = (_e1217 + 2i);
let _e1231 = select(_e1220, _e1229, (_e1229 < _e1220));
let _e1237 = global_5.member[bitcast<u32>(select(0i, _e1231, (_e1231 > 0i)))];
let _e1238 = (_e1217 + 3i);
let _e1240 = select(_e1220, _e1238, (_e1238 < _e1220));
let _e1246 = global_5.member[bitcast<u32>(select(0i, _e1240, (_e1240 > 0i)))];
let _e1249 = (_e1182 - bitcast<i32>((_e1228 & 65535u)));
let _e1254 = bitcast<i32>((_e1228 >> bitcast<u32>(16i)));
let _e1259 = (_e1199 - bitcast<i32>((_e1237 & 65535u)));
let _e1264 = bitcast<i32>((_e1237 >> bitcast<u32>(16i)));
let _e1269 = (_e1216 - bitcast<i32>((_e1246 & 65535u)));
if ((((_e1249 >= 0i) && ((_e1249 + 1i) < _e1254)) && ((_e1259 >= 0i) && ((_e1259 + 1i) < _e1264))) && ((_e1269 >= 0i) && ((_e1269 + 1i) < bitcast<i32>((_e1246 >> bitcast<u32>(16i)))))) {
let _e1279 = (_e1264 * _e1254);
let _e1281 = select(_e1220, _e1217, (_e1217 < _e1220));
let _e1287 = global_5.member[bitcast<u32>(select(0i, _e1281, (_e1281 > 0i)))];
let _e1293 = (((bitcast<i32>(_e1287) + (_e1269 * _e1279)) + (_e1259 * _e1254)) + _e1249);
let _e1295 = (_e1163 - f32(_e1182));
let _e1297 = (_e1164 - f32(_e1199));
let _e1300 = (2i * _e1293);
let _e1302 = (_e1300 >> bitcast<u32>(2i));
let _e1305 = bitcast<u32>(((_e1300 & 3i) * 8i));
let _e1307 = select(_e1220, _e1302, (_e1302 < _e1220));
let _e1313 = global_5.member[bitcast<u32>(select(0i, _e1307, (_e1307 > 0i)))];
let _e1317 = (_e1302 + 1i);
let _e1319 = select(_e1220, _e1317, (_e1317 < _e1220));
let _e1325 = global_5.member[bitcast<u32>(select(0i, _e1319, (_e1319 > 0i)))];
let _e1332 = ((_e1313 >> bitcast<u32>((_e1305 & 31u))) | ((_e1325 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1305) & 31u))));
let _e1335 = f32(bitcast<i32>((_e1332 & 65535u)));
let _e1342 = (_e1335 + ((f32(bitcast<i32>((_e1332 >> bitcast<u32>(16i)))) - _e1335) * _e1295));
let _e1344 = (2i * (_e1293 + _e1254));
let _e1346 = (_e1344 >> bitcast<u32>(2i));
let _e1349 = bitcast<u32>(((_e1344 & 3i) * 8i));
let _e1351 = select(_e1220, _e1346, (_e1346 < _e1220));
let _e1357 = global_5.member[bitcast<u32>(select(0i, _e1351, (_e1351 > 0i)))];
let _e1361 = (_e1346 + 1i);
let _e1363 = select(_e1220, _e1361, (_e1361 < _e1220));
let _e1369 = global_5.member[bitcast<u32>(select(0i, _e1363, (_e1363 > 0i)))];
let _e1376 = ((_e1357 >> bitcast<u32>((_e1349 & 31u))) | ((_e1369 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1349) & 31u))));
let _e1379 = f32(bitcast<i32>((_e1376 & 65535u)));
let _e1387 = (_e1293 + _e1279);
let _e1388 = (2i * _e1387);
let _e1390 = (_e1388 >> bitcast<u32>(2i));
let _e1393 = bitcast<u32>(((_e1388 & 3i) * 8i));
let _e1395 = select(_e1220, _e1390, (_e1390 < _e1220));
let _e1401 = global_5.member[bitcast<u32>(select(0i, _e1395, (_e1395 > 0i)))];
let _e1405 = (_e1390 + 1i);
let _e1407 = select(_e1220, _e1405, (_e1405 < _e1220));
let _e1413 = global_5.member[bitcast<u32>(select(0i, _e1407, (_e1407 > 0i)))];
let _e1420 = ((_e1401 >> bitcast<u32>((_e1393 & 31u))) | ((_e1413 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1393) & 31u))));
let _e1423 = f32(bitcast<i32>((_e1420 & 65535u)));
let _e1430 = (_e1423 + ((f32(bitcast<i32>((_e1420 >> bitcast<u32>(16i)))) - _e1423) * _e1295));
let _e1432 = (2i * (_e1387 + _e1254));
let _e1434 = (_e1432 >> bitcast<u32>(2i));
let _e1437 = bitcast<u32>(((_e1432 & 3i) * 8i));
let _e1439 = select(_e1220, _e1434, (_e1434 < _e1220));
let _e1445 = global_5.member[bitcast<u32>(select(0i, _e1439, (_e1439 > 0i)))];
let _e1449 = (_e1434 + 1i);
let _e1451 = select(_e1220, _e1449, (_e1449 < _e1220));
let _e1457 = global_5.member[bitcast<u32>(select(0i, _e1451, (_e1451 > 0i)))];
let _e1464 = ((_e1445 >> bitcast<u32>((_e1437 & 31u))) | ((_e1457 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1437) & 31u))));
let _e1467 = f32(bitcast<i32>((_e1464 & 65535u)));
let _e1477 = (_e1342 + (((_e1379 + ((f32(bitcast<i32>((_e1376 >> bitcast<u32>(16i)))) - _e1379) * _e1295)) - _e1342) * _e1297));
phi_2168_ = (_e1477 + (((_e1430 + (((_e1467 + ((f32(bitcast<i32>((_e1464 >> bitcast<u32>(16i)))) - _e1467) * _e1295)) - _e1430) * _e1297)) - _e1477) * (_e1165 - f32(_e1216))));
} else {
phi_2168_ = 0f;
}
let _e1485 = phi_2168_;
phi_1730_ = (_e1144 - 1i);
phi_1733_ = select(_e1146, _e1144, (_e1485 > 32767.5f));
} else {
phi_1730_ = i32();
phi_1733_ = i32();
}
let _e1490 = phi_1730_;
let _e1492 = phi_1733_;
continue;
continuing {
phi_1729_ = _e1490;
phi_1732_ = _e1492;
break if !(_e1147);
}
}
let _e1495 = local_7;
let _e1496 = (_e1495 == _e919.member_7);
if _e1496 {
phi_13736_ = _e919;
phi_13737_ = _e1496;
} else {
phi_2180_ = 0i;
phi_2183_ = 0f;
phi_2185_ = _e1130;
loop {
let _e1498 = phi_2180_;
let _e1500 = phi_2183_;
let _e1502 = phi_2185_;
local_9 = _e1502;
local_10 = _e1502;
local_11 = _e1502;
local_14 = _e1502;
local_16 = _e1502;
let _e1503 = (_e1498 < 12i);
if _e1503 {
let _e1505 = (0.5f * (_e1500 + _e1502));
phi_2214_ = _e1142;
phi_2217_ = 16i;
loop {
let _e1513 = phi_2214_;
let _e1515 = phi_2217_;
local_8 = _e1515;
let _e1516 = (_e1513 >= 0i);
if _e1516 {
let _e1520 = global_1.member.member_2.member;
let _e1525 = global_1.member.member_2.member_1;
let _e1530 = global_1.member.member_2.member_2;
let _e1532 = ((_e919.member.x + (_e919.member_1.x * _e1505)) - 0.5f);
let _e1533 = ((_e919.member.y + (_e919.member_1.y * _e1505)) - 0.5f);
let _e1534 = ((_e919.member.z + (_e919.member_1.z * _e1505)) - 0.5f);
let _e1536 = f32((bitcast<i32>(_e1520) - 2i));
let _e1538 = select(0f, _e1532, (_e1532 > 0f));
let _e1540 = select(_e1536, _e1538, (_e1538 < _e1536));
let _e1547 = select(0i, select(select(i32(_e1540), i32(-2147483648), (_e1540 < -2147483600f)), 2147483647i, (_e1540 > 2147483500f)), (_e1540 == _e1540));
let _e1551 = (_e1547 - select(0i, 1i, (_e1540 < f32(_e1547))));
let _e1553 = f32((bitcast<i32>(_e1525) - 2i));
let _e1555 = select(0f, _e1533, (_e1533 > 0f));
let _e1557 = select(_e1553, _e1555, (_e1555 < _e1553));
let _e1564 = select(0i, select(select(i32(_e1557), i32(-2147483648), (_e1557 < -2147483600f)), 2147483647i, (_e1557 > 2147483500f)), (_e1557 == _e1557));
let _e1568 = (_e1564 - select(0i, 1i, (_e1557 < f32(_e1564))));
let _e1570 = f32((bitcast<i32>(_e1530) - 2i));
let _e1572 = select(0f, _e1534, (_e1534 > 0f));
let _e1574 = select(_e1570, _e1572, (_e1572 < _e1570));
let _e1581 = select(0i, select(select(i32(_e1574), i32(-2147483648), (_e1574 < -2147483600f)), 2147483647i, (_e1574 > 2147483500f)), (_e1574 == _e1574));
let _e1585 = (_e1581 - select(0i, 1i, (_e1574 < f32(_e1581))));
let _e1586 = (_e1513 * 4i);
let _e1587 = (_e1586 + 1i);
let _e1589 = (bitcast<i32>(_e116) - 1i);
let _e1591 = select(_e1589, _e1587, (_e1587 < _e1589));
let _e1597 = global_5.member[bitcast<u32>(select(0i, _e1591, (_e1591 > 0i)))];
let _e1598 = (_e1586 + 2i);
let _e1600 = select(_e1589, _e1598, (_e1598 < _e1589));
let _e1606 = global_5.member[bitcast<u32>(select(0i, _e1600, (_e1600 > 0i)))];
let _e1607 = (_e1586 + 3i);
let _e1609 = select(_e1589, _e1607, (_e1607 < _e1589));
let _e1615 = global_5.member[bitcast<u32>(select(0i, _e1609, (_e1609 > 0i)))];
let _e1618 = (_e1551 - bitcast<i32>((_e1597 & 65535u)));
let _e1623 = bitcast<i32>((_e1597 >> bitcast<u32>(16i)));
let _e1628 = (_e1568 - bitcast<i32>((_e1606 & 65535u)));
let _e1633 = bitcast<i32>((_e1606 >> bitcast<u32>(16i)));
let _e1638 = (_e1585 - bitcast<i32>((_e1615 & 65535u)));
if ((((_e1618 >= 0i) && ((_e1618 + 1i) < _e1623)) && ((_e1628 >= 0i) && ((_e1628 + 1i) < _e1633))) && ((_e1638 >= 0i) && ((_e1638 + 1i) < bitcast<i32>((_e1615 >> bitcast<u32>(16i)))))) {
let _e1648 = (_e1633 * _e1623);
let _e1650 = select(_e1589, _e1586, (_e1586 < _e1589));
let _e1656 = global_5.member[bitcast<u32>(select(0i, _e1650, (_e1650 > 0i)))];
let _e1662 = (((bitcast<i32>(_e1656) + (_e1638 * _e1648)) + (_e1628 * _e1623)) + _e1618);
let _e1664 = (_e1532 - f32(_e1551));
let _e1666 = (_e1533 - f32(_e1568));
let _e1669 = (2i * _e1662);
let _e1671 = (_e1669 >> bitcast<u32>(2i));
let _e1674 = bitcast<u32>(((_e1669 & 3i) * 8i));
let _e1676 = select(_e1589, _e1671, (_e1671 < _e1589));
let _e1682 = global_5.member[bitcast<u32>(select(0i, _e1676, (_e1676 > 0i)))];
let _e1686 = (_e1671 + 1i);
let _e1688 = select(_e1589, _e1686, (_e1686 < _e1589));
let _e1694 = global_5.member[bitcast<u32>(select(0i, _e1688, (_e1688 > 0i)))];
let _e1701 = ((_e1682 >> bitcast<u32>((_e1674 & 31u))) | ((_e1694 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1674) & 31u))));
let _e1704 = f32(bitcast<i32>((_e1701 & 65535u)));
let _e1711 = (_e1704 + ((f32(bitcast<i32>((_e1701 >> bitcast<u32>(16i)))) - _e1704) * _e1664));
let _e1713 = (2i * (_e1662 + _e1623));
let _e1715 = (_e1713 >> bitcast<u32>(2i));
let _e1718 = bitcast<u32>(((_e1713 & 3i) * 8i));
let _e1720 = select(_e1589, _e1715, (_e1715 < _e1589));
let _e1726 = global_5.member[bitcast<u32>(select(0i, _e1720, (_e1720 > 0i)))];
let _e1730 = (_e1715 + 1i);
let _e1732 = select(_e1589, _e1730, (_e1730 < _e1589));
let _e1738 = global_5.member[bitcast<u32>(select(0i, _e1732, (_e1732 > 0i)))];
let _e1745 = ((_e1726 >> bitcast<u32>((_e1718 & 31u))) | ((_e1738 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1718) & 31u))));
let _e1748 = f32(bitcast<i32>((_e1745 & 65535u)));
let _e1756 = (_e1662 + _e1648);
let _e1757 = (2i * _e1756);
let _e1759 = (_e1757 >> bitcast<u32>(2i));
let _e1762 = bitcast<u32>(((_e1757 & 3i) * 8i));
let _e1764 = select(_e1589, _e1759, (_e1759 < _e1589));
let _e1770 = global_5.member[bitcast<u32>(select(0i, _e1764, (_e1764 > 0i)))];
let _e1774 = (_e1759 + 1i);
let _e1776 = select(_e1589, _e1774, (_e1774 < _e1589));
let _e1782 = global_5.member[bitcast<u32>(select(0i, _e1776, (_e1776 > 0i)))];
let _e1789 = ((_e1770 >> bitcast<u32>((_e1762 & 31u))) | ((_e1782 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1762) & 31u))));
let _e1792 = f32(bitcast<i32>((_e1789 & 65535u)));
let _e1799 = (_e1792 + ((f32(bitcast<i32>((_e1789 >> bitcast<u32>(16i)))) - _e1792) * _e1664));
let _e1801 = (2i * (_e1756 + _e1623));
let _e1803 = (_e1801 >> bitcast<u32>(2i));
let _e1806 = bitcast<u32>(((_e1801 & 3i) * 8i));
let _e1808 = select(_e1589, _e1803, (_e1803 < _e1589));
let _e1814 = global_5.member[bitcast<u32>(select(0i, _e1808, (_e1808 > 0i)))];
let _e1818 = (_e1803 + 1i);
let _e1820 = select(_e1589, _e1818, (_e1818 < _e1589));
let _e1826 = global_5.member[bitcast<u32>(select(0i, _e1820, (_e1820 > 0i)))];
let _e1833 = ((_e1814 >> bitcast<u32>((_e1806 & 31u))) | ((_e1826 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1806) & 31u))));
let _e1836 = f32(bitcast<i32>((_e1833 & 65535u)));
let _e1846 = (_e1711 + (((_e1748 + ((f32(bitcast<i32>((_e1745 >> bitcast<u32>(16i)))) - _e1748) * _e1664)) - _e1711) * _e1666));
phi_2653_ = (_e1846 + (((_e1799 + (((_e1836 + ((f32(bitcast<i32>((_e1833 >> bitcast<u32>(16i)))) - _e1836) * _e1664)) - _e1799) * _e1666)) - _e1846) * (_e1534 - f32(_e1585))));
} else {
phi_2653_ = 0f;
}
let _e1854 = phi_2653_;
phi_2215_ = (_e1513 - 1i);
phi_2218_ = select(_e1515, _e1513, (_e1854 > 32767.5f));
} else {
phi_2215_ = i32();
phi_2218_ = i32();
}
let _e1859 = phi_2215_;
let _e1861 = phi_2218_;
continue;
continuing {
phi_2214_ = _e1859;
phi_2217_ = _e1861;
break if !(_e1516);
}
}
let _e1864 = local_8;
let _e1865 = (_e1864 == _e919.member_7);
phi_2181_ = (_e1498 + 1i);
phi_2184_ = select(_e1500, _e1505, _e1865);
phi_2186_ = select(_e1505, _e1502, _e1865);
} else {
phi_2181_ = i32();
phi_2184_ = f32();
phi_2186_ = f32();
}
let _e1870 = phi_2181_;
let _e1872 = phi_2184_;
let _e1874 = phi_2186_;
continue;
continuing {
phi_2180_ = _e1870;
phi_2183_ = _e1872;
phi_2185_ = _e1874;
break if !(_e1503);
}
}
let _e1877 = local_9;
let _e1878 = (_e919.member_1.x * _e1877);
let _e1880 = local_10;
let _e1881 = (_e919.member_1.y * _e1880);
let _e1883 = local_11;
let _e1884 = (_e919.member_1.z * _e1883);
let _e1885 = (_e919.member.x + _e1878);
let _e1886 = (_e919.member.y + _e1881);
let _e1887 = (_e919.member.z + _e1884);
phi_2688_ = _e1142;
phi_2691_ = 16i;
loop {
let _e1891 = phi_2688_;
let _e1893 = phi_2691_;
local_12 = _e1893;
local_13 = _e1893;
local_15 = _e1893;
local_17 = _e1893;
local_18 = _e1893;
local_19 = _e1893;
local_20 = _e1893;
let _e1894 = (_e1891 >= 0i);
if _e1894 {
let _e1898 = global_1.member.member_2.member;
let _e1903 = global_1.member.member_2.member_1;
let _e1908 = global_1.member.member_2.member_2;
let _e1910 = (_e1885 - 0.5f);
let _e1911 = (_e1886 - 0.5f);
let _e1912 = (_e1887 - 0.5f);
let _e1914 = f32((bitcast<i32>(_e1898) - 2i));
let _e1916 = select(0f, _e1910, (_e1910 > 0f));
let _e1918 = select(_e1914, _e1916, (_e1916 < _e1914));
let _e1925 = select(0i, select(select(i32(_e1918), i32(-2147483648), (_e1918 < -2147483600f)), 2147483647i, (_e1918 > 2147483500f)), (_e1918 == _e1918));
let _e1929 = (_e1925 - select(0i, 1i, (_e1918 < f32(_e1925))));
let _e1931 = f32((bitcast<i32>(_e1903) - 2i));
let _e1933 = select(0f, _e1911, (_e1911 > 0f));
let _e1935 = select(_e1931, _e1933, (_e1933 < _e1931));
let _e1942 = select(0i, select(select(i32(_e1935), i32(-2147483648), (_e1935 < -2147483600f)), 2147483647i, (_e1935 > 2147483500f)), (_e1935 == _e1935));
let _e1946 = (_e1942 - select(0i, 1i, (_e1935 < f32(_e1942))));
let _e1948 = f32((bitcast<i32>(_e1908) - 2i));
let _e1950 = select(0f, _e1912, (_e1912 > 0f));
let _e1952 = select(_e1948, _e1950, (_e1950 < _e1948));
let _e1959 = select(0i, select(select(i32(_e1952), i32(-2147483648), (_e1952 < -2147483600f)), 2147483647i, (_e1952 > 2147483500f)), (_e1952 == _e1952));
let _e1963 = (_e1959 - select(0i, 1i, (_e1952 < f32(_e1959))));
let _e1964 = (_e1891 * 4i);
let _e1965 = (_e1964 + 1i);
let _e1967 = (bitcast<i32>(_e116) - 1i);
let _e1969 = select(_e1967, _e1965, (_e1965 < _e1967));
let _e1975 = global_5.member[bitcast<u32>(select(0i, _e1969, (_e1969 > 0i)))];
let _e1976 = (_e1964 + 2i);
let _e1978 = select(_e1967, _e1976, (_e1976 < _e1967));
let _e1984 = global_5.member[bitcast<u32>(select(0i, _e1978, (_e1978 > 0i)))];
let _e1985 = (_e1964 + 3i);
let _e1987 = select(_e1967, _e1985, (_e1985 < _e1967));
let _e1993 = global_5.member[bitcast<u32>(select(0i, _e1987, (_e1987 > 0i)))];
let _e1996 = (_e1929 - bitcast<i32>((_e1975 & 65535u)));
let _e2001 = bitcast<i32>((_e1975 >> bitcast<u32>(16i)));
let _e2006 = (_e1946 - bitcast<i32>((_e1984 & 65535u)));
let _e2011 = bitcast<i32>((_e1984 >> bitcast<u32>(16i)));
let _e2016 = (_e1963 - bitcast<i32>((_e1993 & 65535u)));
if ((((_e1996 >= 0i) && ((_e1996 + 1i) < _e2001)) && ((_e2006 >= 0i) && ((_e2006 + 1i) < _e2011))) && ((_e2016 >= 0i) && ((_e2016 + 1i) < bitcast<i32>((_e1993 >> bitcast<u32>(16i)))))) {
let _e2026 = (_e2011 * _e2001);
let _e2028 = select(_e1967, _e1964, (_e1964 < _e1967));
let _e2034 = global_5.member[bitcast<u32>(select(0i, _e2028, (_e2028 > 0i)))];
let _e2040 = (((bitcast<i32>(_e2034) + (_e2016 * _e2026)) + (_e2006 * _e2001)) + _e1996);
let _e2042 = (_e1910 - f32(_e1929));
let _e2044 = (_e1911 - f32(_e1946));
let _e2047 = (2i * _e2040);
let _e2049 = (_e2047 >> bitcast<u32>(2i));
let _e2052 = bitcast<u32>(((_e2047 & 3i) * 8i));
let _e2054 = select(_e1967, _e2049, (_e2049 < _e1967));
let _e2060 = global_5.member[bitcast<u32>(select(0i, _e2054, (_e2054 > 0i)))];
let _e2064 = (_e2049 + 1i);
let _e2066 = select(_e1967, _e2064, (_e2064 < _e1967));
let _e2072 = global_5.member[bitcast<u32>(select(0i, _e2066, (_e2066 > 0i)))];
let _e2079 = ((_e2060 >> bitcast<u32>((_e2052 & 31u))) | ((_e2072 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2052) & 31u))));
let _e2082 = f32(bitcast<i32>((_e2079 & 65535u)));
let _e2089 = (_e2082 + ((f32(bitcast<i32>((_e2079 >> bitcast<u32>(16i)))) - _e2082) * _e2042));
let _e2091 = (2i * (_e2040 + _e2001));
let _e2093 = (_e2091 >> bitcast<u32>(2i));
let _e2096 = bitcast<u32>(((_e2091 & 3i) * 8i));
let _e2098 = select(_e1967, _e2093, (_e2093 < _e1967));
let _e2104 = global_5.member[bitcast<u32>(select(0i, _e2098, (_e2098 > 0i)))];
let _e2108 = (_e2093 + 1i);
let _e2110 = select(_e1967, _e2108, (_e2108 < _e1967));
let _e2116 = global_5.member[bitcast<u32>(select(0i, _e2110, (_e2110 > 0i)))];
let _e2123 = ((_e2104 >> bitcast<u32>((_e2096 & 31u))) | ((_e2116 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2096) & 31u))));
let _e2126 = f32(bitcast<i32>((_e2123 & 65535u)));
let _e2134 = (_e2040 + _e2026);
let _e2135 = (2i * _e2134);
let _e2137 = (_e2135 >> bitcast<u32>(2i));
let _e2140 = bitcast<u32>(((_e2135 & 3i) * 8i));
let _e2142 = select(_e1967, _e2137, (_e2137 < _e1967));
let _e2148 = global_5.member[bitcast<u32>(select(0i, _e2142, (_e2142 > 0i)))];
let _e2152 = (_e2137 + 1i);
let _e2154 = select(_e1967, _e2152, (_e2152 < _e1967));
let _e2160 = global_5.member[bitcast<u32>(select(0i, _e2154, (_e2154 > 0i)))];
let _e2167 = ((_e2148 >> bitcast<u32>((_e2140 & 31u))) | ((_e2160 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2140) & 31u))));
let _e2170 = f32(bitcast<i32>((_e2167 & 65535u)));
let _e2177 = (_e2170 + ((f32(bitcast<i32>((_e2167 >> bitcast<u32>(16i)))) - _e2170) * _e2042));
let _e2179 = (2i * (_e2134 + _e2001));
let _e2181 = (_e2179 >> bitcast<u32>(2i));
let _e2184 = bitcast<u32>(((_e2179 & 3i) * 8i));
let _e2186 = select(_e1967, _e2181, (_e2181 < _e1967));
let _e2192 = global_5.member[bitcast<u32>(select(0i, _e2186, (_e2186 > 0i)))];
let _e2196 = (_e2181 + 1i);
let _e2198 = select(_e1967, _e2196, (_e2196 < _e1967));
let _e2204 = global_5.member[bitcast<u32>(select(0i, _e2198, (_e2198 > 0i)))];
let _e2211 = ((_e2192 >> bitcast<u32>((_e2184 & 31u))) | ((_e2204 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2184) & 31u))));
let _e2214 = f32(bitcast<i32>((_e2211 & 65535u)));
let _e2224 = (_e2089 + (((_e2126 + ((f32(bitcast<i32>((_e2123 >> bitcast<u32>(16i)))) - _e2126) * _e2042)) - _e2089) * _e2044));
phi_3127_ = (_e2224 + (((_e2177 + (((_e2214 + ((f32(bitcast<i32>((_e2211 >> bitcast<u32>(16i)))) - _e2214) * _e2042)) - _e2177) * _e2044)) - _e2224) * (_e1912 - f32(_e1963))));
} else {
phi_3127_ = 0f;
}
let _e2232 = phi_3127_;
phi_2689_ = (_e1891 - 1i);
phi_2692_ = select(_e1893, _e1891, (_e2232 > 32767.5f));
} else {
phi_2689_ = i32();
phi_2692_ = i32();
}
let _e2237 = phi_2689_;
let _e2239 = phi_2692_;
continue;
continuing {
phi_2688_ = _e2237;
phi_2691_ = _e2239;
break if !(_e1894);
}
}
let _e2242 = local_12;
let _e2245 = local_13;
let _e2246 = select(_e919.member_7, _e2245, (_e2242 < _e919.member_7));
local_4 = _e2246;
local_5 = (_e919.member + vec3<f32>(_e1878, _e1881, _e1884));
let _e2250 = local_4;
let _e2251 = local_5[0u];
let _e2253 = local_5[1u];
let _e2255 = local_5[2u];
let _e2259 = global_1.member.member_2.member;
let _e2263 = global_1.member.member_2.member_1;
let _e2267 = global_1.member.member_2.member_2;
let _e2269 = ((_e2251 + -1f) - 0.5f);
let _e2270 = ((_e2253 + 0f) - 0.5f);
let _e2271 = ((_e2255 + 0f) - 0.5f);
let _e2273 = f32((bitcast<i32>(_e2259) - 2i));
let _e2275 = select(0f, _e2269, (_e2269 > 0f));
let _e2277 = select(_e2273, _e2275, (_e2275 < _e2273));
let _e2284 = select(0i, select(select(i32(_e2277), i32(-2147483648), (_e2277 < -2147483600f)), 2147483647i, (_e2277 > 2147483500f)), (_e2277 == _e2277));
let _e2288 = (_e2284 - select(0i, 1i, (_e2277 < f32(_e2284))));
let _e2290 = f32((bitcast<i32>(_e2263) - 2i));
let _e2292 = select(0f, _e2270, (_e2270 > 0f));
let _e2294 = select(_e2290, _e2292, (_e2292 < _e2290));
let _e2301 = select(0i, select(select(i32(_e2294), i32(-2147483648), (_e2294 < -2147483600f)), 2147483647i, (_e2294 > 2147483500f)), (_e2294 == _e2294));
let _e2305 = (_e2301 - select(0i, 1i, (_e2294 < f32(_e2301))));
let _e2307 = f32((bitcast<i32>(_e2267) - 2i));
let _e2309 = select(0f, _e2271, (_e2271 > 0f));
let _e2311 = select(_e2307, _e2309, (_e2309 < _e2307));
let _e2318 = select(0i, select(select(i32(_e2311), i32(-2147483648), (_e2311 < -2147483600f)), 2147483647i, (_e2311 > 2147483500f)), (_e2311 == _e2311));
let _e2322 = (_e2318 - select(0i, 1i, (_e2311 < f32(_e2318))));
let _e2323 = (_e2250 * 4i);
let _e2324 = (_e2323 + 1i);
let _e2326 = (bitcast<i32>(_e116) - 1i);
let _e2328 = select(_e2326, _e2324, (_e2324 < _e2326));
let _e2333 = global_5.member[bitcast<u32>(select(0i, _e2328, (_e2328 > 0i)))];
let _e2334 = (_e2323 + 2i);
let _e2336 = select(_e2326, _e2334, (_e2334 < _e2326));
let _e2341 = global_5.member[bitcast<u32>(select(0i, _e2336, (_e2336 > 0i)))];
let _e2342 = (_e2323 + 3i);
let _e2344 = select(_e2326, _e2342, (_e2342 < _e2326));
let _e2349 = global_5.member[bitcast<u32>(select(0i, _e2344, (_e2344 > 0i)))];
let _e2352 = (_e2288 - bitcast<i32>((_e2333 & 65535u)));
let _e2357 = bitcast<i32>((_e2333 >> bitcast<u32>(16i)));
let _e2362 = (_e2305 - bitcast<i32>((_e2341 & 65535u)));
let _e2367 = bitcast<i32>((_e2341 >> bitcast<u32>(16i)));
let _e2372 = (_e2322 - bitcast<i32>((_e2349 & 65535u)));
if ((((_e2352 >= 0i) && ((_e2352 + 1i) < _e2357)) && ((_e2362 >= 0i) && ((_e2362 + 1i) < _e2367))) && ((_e2372 >= 0i) && ((_e2372 + 1i) < bitcast<i32>((_e2349 >> bitcast<u32>(16i)))))) {
let _e2382 = (_e2367 * _e2357);
let _e2384 = select(_e2326, _e2323, (_e2323 < _e2326));
let _e2389 = global_5.member[bitcast<u32>(select(0i, _e2384, (_e2384 > 0i)))];
let _e2395 = (((bitcast<i32>(_e2389) + (_e2372 * _e2382)) + (_e2362 * _e2357)) + _e2352);
let _e2397 = (_e2269 - f32(_e2288));
let _e2399 = (_e2270 - f32(_e2305));
let _e2402 = (2i * _e2395);
let _e2404 = (_e2402 >> bitcast<u32>(2i));
let _e2407 = bitcast<u32>(((_e2402 & 3i) * 8i));
let _e2409 = select(_e2326, _e2404, (_e2404 < _e2326));
let _e2414 = global_5.member[bitcast<u32>(select(0i, _e2409, (_e2409 > 0i)))];
let _e2418 = (_e2404 + 1i);
let _e2420 = select(_e2326, _e2418, (_e2418 < _e2326));
let _e2425 = global_5.member[bitcast<u32>(select(0i, _e2420, (_e2420 > 0i)))];
let _e2432 = ((_e2414 >> bitcast<u32>((_e2407 & 31u))) | ((_e2425 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2407) & 31u))));
let _e2435 = f32(bitcast<i32>((_e2432 & 65535u)));
let _e2442 = (_e2435 + ((f32(bitcast<i32>((_e2432 >> bitcast<u32>(16i)))) - _e2435) * _e2397));
let _e2444 = (2i * (_e2395 + _e2357));
let _e2446 = (_e2444 >> bitcast<u32>(2i));
let _e2449 = bitcast<u32>(((_e2444 & 3i) * 8i));
let _e2451 = select(_e2326, _e2446, (_e2446 < _e2326));
let _e2456 = global_5.member[bitcast<u32>(select(0i, _e2451, (_e2451 > 0i)))];
let _e2460 = (_e2446 + 1i);
let _e2462 = select(_e2326, _e2460, (_e2460 < _e2326));
let _e2467 = global_5.member[bitcast<u32>(select(0i, _e2462, (_e2462 > 0i)))];
let _e2474 = ((_e2456 >> bitcast<u32>((_e2449 & 31u))) | ((_e2467 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2449) & 31u))));
let _e2477 = f32(bitcast<i32>((_e2474 & 65535u)));
let _e2485 = (_e2395 + _e2382);
let _e2486 = (2i * _e2485);
let _e2488 = (_e2486 >> bitcast<u32>(2i));
let _e2491 = bitcast<u32>(((_e2486 & 3i) * 8i));
let _e2493 = select(_e2326, _e2488, (_e2488 < _e2326));
let _e2498 = global_5.member[bitcast<u32>(select(0i, _e2493, (_e2493 > 0i)))];
let _e2502 = (_e2488 + 1i);
let _e2504 = select(_e2326, _e2502, (_e2502 < _e2326));
let _e2509 = global_5.member[bitcast<u32>(select(0i, _e2504, (_e2504 > 0i)))];
let _e2516 = ((_e2498 >> bitcast<u32>((_e2491 & 31u))) | ((_e2509 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2491) & 31u))));
let _e2519 = f32(bitcast<i32>((_e2516 & 65535u)));
let _e2526 = (_e2519 + ((f32(bitcast<i32>((_e2516 >> bitcast<u32>(16i)))) - _e2519) * _e2397));
let _e2528 = (2i * (_e2485 + _e2357));
let _e2530 = (_e2528 >> bitcast<u32>(2i));
let _e2533 = bitcast<u32>(((_e2528 & 3i) * 8i));
let _e2535 = select(_e2326, _e2530, (_e2530 < _e2326));
let _e2540 = global_5.member[bitcast<u32>(select(0i, _e2535, (_e2535 > 0i)))];
let _e2544 = (_e2530 + 1i);
let _e2546 = select(_e2326, _e2544, (_e2544 < _e2326));
let _e2551 = global_5.member[bitcast<u32>(select(0i, _e2546, (_e2546 > 0i)))];
let _e2558 = ((_e2540 >> bitcast<u32>((_e2533 & 31u))) | ((_e2551 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2533) & 31u))));
let _e2561 = f32(bitcast<i32>((_e2558 & 65535u)));
let _e2571 = (_e2442 + (((_e2477 + ((f32(bitcast<i32>((_e2474 >> bitcast<u32>(16i)))) - _e2477) * _e2397)) - _e2442) * _e2399));
phi_3587_ = (_e2571 + (((_e2526 + (((_e2561 + ((f32(bitcast<i32>((_e2558 >> bitcast<u32>(16i)))) - _e2561) * _e2397)) - _e2526) * _e2399)) - _e2571) * (_e2271 - f32(_e2322))));
} else {
phi_3587_ = 0f;
}
let _e2579 = phi_3587_;
let _e2580 = local_4;
let _e2581 = local_5[0u];
let _e2583 = local_5[1u];
let _e2585 = local_5[2u];
let _e2587 = ((_e2581 + 1f) - 0.5f);
let _e2588 = ((_e2583 + 0f) - 0.5f);
let _e2589 = ((_e2585 + 0f) - 0.5f);
let _e2591 = select(0f, _e2587, (_e2587 > 0f));
let _e2593 = select(_e2273, _e2591, (_e2591 < _e2273));
let _e2600 = select(0i, select(select(i32(_e2593), i32(-2147483648), (_e2593 < -2147483600f)), 2147483647i, (_e2593 > 2147483500f)), (_e2593 == _e2593));
let _e2604 = (_e2600 - select(0i, 1i, (_e2593 < f32(_e2600))));
let _e2606 = select(0f, _e2588, (_e2588 > 0f));
let _e2608 = select(_e2290, _e2606, (_e2606 < _e2290));
let _e2615 = select(0i, select(select(i32(_e2608), i32(-2147483648), (_e2608 < -2147483600f)), 2147483647i, (_e2608 > 2147483500f)), (_e2608 == _e2608));
let _e2619 = (_e2615 - select(0i, 1i, (_e2608 < f32(_e2615))));
let _e2621 = select(0f, _e2589, (_e2589 > 0f));
let _e2623 = select(_e2307, _e2621, (_e2621 < _e2307));
let _e2630 = select(0i, select(select(i32(_e2623), i32(-2147483648), (_e2623 < -2147483600f)), 2147483647i, (_e2623 > 2147483500f)), (_e2623 == _e2623));
let _e2634 = (_e2630 - select(0i, 1i, (_e2623 < f32(_e2630))));
let _e2635 = (_e2580 * 4i);
let _e2636 = (_e2635 + 1i);
let _e2638 = select(_e2326, _e2636, (_e2636 < _e2326));
let _e2643 = global_5.member[bitcast<u32>(select(0i, _e2638, (_e2638 > 0i)))];
let _e2644 = (_e2635 + 2i);
let _e2646 = select(_e2326, _e2644, (_e2644 < _e2326));
let _e2651 = global_5.member[bitcast<u32>(select(0i, _e2646, (_e2646 > 0i)))];
let _e2652 = (_e2635 + 3i);
let _e2654 = select(_e2326, _e2652, (_e2652 < _e2326));
let _e2659 = global_5.member[bitcast<u32>(select(0i, _e2654, (_e2654 > 0i)))];
let _e2662 = (_e2604 - bitcast<i32>((_e2643 & 65535u)));
let _e2667 = bitcast<i32>((_e2643 >> bitcast<u32>(16i)));
let _e2672 = (_e2619 - bitcast<i32>((_e2651 & 65535u)));
let _e2677 = bitcast<i32>((_e2651 >> bitcast<u32>(16i)));
let _e2682 = (_e2634 - bitcast<i32>((_e2659 & 65535u)));
if ((((_e2662 >= 0i) && ((_e2662 + 1i) < _e2667)) && ((_e2672 >= 0i) && ((_e2672 + 1i) < _e2677))) && ((_e2682 >= 0i) && ((_e2682 + 1i) < bitcast<i32>((_e2659 >> bitcast<u32>(16i)))))) {
let _e2692 = (_e2677 * _e2667);
let _e2694 = select(_e2326, _e2635, (_e2635 < _e2326));
let _e2699 = global_5.member[bitcast<u32>(select(0i, _e2694, (_e2694 > 0i)))];
let _e2705 = (((bitcast<i32>(_e2699) + (_e2682 * _e2692)) + (_e2672 * _e2667)) + _e2662);
let _e2707 = (_e2587 - f32(_e2604));
let _e2709 = (_e2588 - f32(_e2619));
let _e2712 = (2i * _e2705);
let _e2714 = (_e2712 >> bitcast<u32>(2i));
let _e2717 = bitcast<u32>(((_e2712 & 3i) * 8i));
let _e2719 = select(_e2326, _e2714, (_e2714 < _e2326));
let _e2724 = global_5.member[bitcast<u32>(select(0i, _e2719, (_e2719 > 0i)))];
let _e2728 = (_e2714 + 1i);
let _e2730 = select(_e2326, _e2728, (_e2728 < _e2326));
let _e2735 = global_5.member[bitcast<u32>(select(0i, _e2730, (_e2730 > 0i)))];
let _e2742 = ((_e2724 >> bitcast<u32>((_e2717 & 31u))) | ((_e2735 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2717) & 31u))));
let _e2745 = f32(bitcast<i32>((_e2742 & 65535u)));
let _e2752 = (_e2745 + ((f32(bitcast<i32>((_e2742 >> bitcast<u32>(16i)))) - _e2745) * _e2707));
let _e2754 = (2i * (_e2705 + _e2667));
let _e2756 = (_e2754 >> bitcast<u32>(2i));
let _e2759 = bitcast<u32>(((_e2754 & 3i) * 8i));
let _e2761 = select(_e2326, _e2756, (_e2756 < _e2326));
let _e2766 = global_5.member[bitcast<u32>(select(0i, _e2761, (_e2761 > 0i)))];
let _e2770 = (_e2756 + 1i);
let _e2772 = select(_e2326, _e2770, (_e2770 < _e2326));
let _e2777 = global_5.member[bitcast<u32>(select(0i, _e2772, (_e2772 > 0i)))];
let _e2784 = ((_e2766 >> bitcast<u32>((_e2759 & 31u))) | ((_e2777 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2759) & 31u))));
let _e2787 = f32(bitcast<i32>((_e2784 & 65535u)));
let _e2795 = (_e2705 + _e2692);
let _e2796 = (2i * _e2795);
let _e2798 = (_e2796 >> bitcast<u32>(2i));
let _e2801 = bitcast<u32>(((_e2796 & 3i) * 8i));
let _e2803 = select(_e2326, _e2798, (_e2798 < _e2326));
let _e2808 = global_5.member[bitcast<u32>(select(0i, _e2803, (_e2803 > 0i)))];
let _e2812 = (_e2798 + 1i);
let _e2814 = select(_e2326, _e2812, (_e2812 < _e2326));
let _e2819 = global_5.member[bitcast<u32>(select(0i, _e2814, (_e2814 > 0i)))];
let _e2826 = ((_e2808 >> bitcast<u32>((_e2801 & 31u))) | ((_e2819 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2801) & 31u))));
let _e2829 = f32(bitcast<i32>((_e2826 & 65535u)));
let _e2836 = (_e2829 + ((f32(bitcast<i32>((_e2826 >> bitcast<u32>(16i)))) - _e2829) * _e2707));
let _e2838 = (2i * (_e2795 + _e2667));
let _e2840 = (_e2838 >> bitcast<u32>(2i));
let _e2843 = bitcast<u32>(((_e2838 & 3i) * 8i));
let _e2845 = select(_e2326, _e2840, (_e2840 < _e2326));
let _e2850 = global_5.member[bitcast<u32>(select(0i, _e2845, (_e2845 > 0i)))];
let _e2854 = (_e2840 + 1i);
let _e2856 = select(_e2326, _e2854, (_e2854 < _e2326));
let _e2861 = global_5.member[bitcast<u32>(select(0i, _e2856, (_e2856 > 0i)))];
let _e2868 = ((_e2850 >> bitcast<u32>((_e2843 & 31u))) | ((_e2861 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2843) & 31u))));
let _e2871 = f32(bitcast<i32>((_e2868 & 65535u)));
let _e2881 = (_e2752 + (((_e2787 + ((f32(bitcast<i32>((_e2784 >> bitcast<u32>(16i)))) - _e2787) * _e2707)) - _e2752) * _e2709));
phi_4026_ = (_e2881 + (((_e2836 + (((_e2871 + ((f32(bitcast<i32>((_e2868 >> bitcast<u32>(16i)))) - _e2871) * _e2707)) - _e2836) * _e2709)) - _e2881) * (_e2589 - f32(_e2634))));
} else {
phi_4026_ = 0f;
}
let _e2889 = phi_4026_;
let _e2891 = local_4;
let _e2892 = local_5[0u];
let _e2894 = local_5[1u];
let _e2896 = local_5[2u];
let _e2898 = ((_e2892 + 0f) - 0.5f);
let _e2899 = ((_e2894 + -1f) - 0.5f);
let _e2900 = ((_e2896 + 0f) - 0.5f);
let _e2902 = select(0f, _e2898, (_e2898 > 0f));
let _e2904 = select(_e2273, _e2902, (_e2902 < _e2273));
let _e2911 = select(0i, select(select(i32(_e2904), i32(-2147483648), (_e2904 < -2147483600f)), 2147483647i, (_e2904 > 2147483500f)), (_e2904 == _e2904));
let _e2915 = (_e2911 - select(0i, 1i, (_e2904 < f32(_e2911))));
let _e2917 = select(0f, _e2899, (_e2899 > 0f));
let _e2919 = select(_e2290, _e2917, (_e2917 < _e2290));
let _e2926 = select(0i, select(select(i32(_e2919), i32(-2147483648), (_e2919 < -2147483600f)), 2147483647i, (_e2919 > 2147483500f)), (_e2919 == _e2919));
let _e2930 = (_e2926 - select(0i, 1i, (_e2919 < f32(_e2926))));
let _e2932 = select(0f, _e2900, (_e2900 > 0f));
let _e2934 = select(_e2307, _e2932, (_e2932 < _e2307));
let _e2941 = select(0i, select(select(i32(_e2934), i32(-2147483648), (_e2934 < -2147483600f)), 2147483647i, (_e2934 > 2147483500f)), (_e2934 == _e2934));
let _e2945 = (_e2941 - select(0i, 1i, (_e2934 < f32(_e2941))));
let _e2946 = (_e2891 * 4i);
let _e2947 = (_e2946 + 1i);
let _e2949 = select(_e2326, _e2947, (_e2947 < _e2326));
let _e2954 = global_5.member[bitcast<u32>(select(0i, _e2949, (_e2949 > 0i)))];
let _e2955 = (_e2946 + 2i);
let _e2957 = select(_e2326, _e2955, (_e2955 < _e2326));
let _e2962 = global_5.member[bitcast<u32>(select(0i, _e2957, (_e2957 > 0i)))];
let _e2963 = (_e2946 + 3i);
let _e2965 = select(_e2326, _e2963, (_e2963 < _e2326));
let _e2970 = global_5.member[bitcast<u32>(select(0i, _e2965, (_e2965 > 0i)))];
let _e2973 = (_e2915 - bitcast<i32>((_e2954 & 65535u)));
let _e2978 = bitcast<i32>((_e2954 >> bitcast<u32>(16i)));
let _e2983 = (_e2930 - bitcast<i32>((_e2962 & 65535u)));
let _e2988 = bitcast<i32>((_e2962 >> bitcast<u32>(16i)));
let _e2993 = (_e2945 - bitcast<i32>((_e2970 & 65535u)));
if ((((_e2973 >= 0i) && ((_e2973 + 1i) < _e2978)) && ((_e2983 >= 0i) && ((_e2983 + 1i) < _e2988))) && ((_e2993 >= 0i) && ((_e2993 + 1i) < bitcast<i32>((_e2970 >> bitcast<u32>(16i)))))) {
let _e3003 = (_e2988 * _e2978);
let _e3005 = select(_e2326, _e2946, (_e2946 < _e2326));
let _e3010 = global_5.member[bitcast<u32>(select(0i, _e3005, (_e3005 > 0i)))];
let _e3016 = (((bitcast<i32>(_e3010) + (_e2993 * _e3003)) + (_e2983 * _e2978)) + _e2973);
let _e3018 = (_e2898 - f32(_e2915));
let _e3020 = (_e2899 - f32(_e2930));
let _e3023 = (2i * _e3016);
let _e3025 = (_e3023 >> bitcast<u32>(2i));
let _e3028 = bitcast<u32>(((_e3023 & 3i) * 8i));
let _e3030 = select(_e2326, _e3025, (_e3025 < _e2326));
let _e3035 = global_5.member[bitcast<u32>(select(0i, _e3030, (_e3030 > 0i)))];
let _e3039 = (_e3025 + 1i);
let _e3041 = select(_e2326, _e3039, (_e3039 < _e2326));
let _e3046 = global_5.member[bitcast<u32>(select(0i, _e3041, (_e3041 > 0i)))];
let _e3053 = ((_e3035 >> bitcast<u32>((_e3028 & 31u))) | ((_e3046 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3028) & 31u))));
let _e3056 = f32(bitcast<i32>((_e3053 & 65535u)));
let _e3063 = (_e3056 + ((f32(bitcast<i32>((_e3053 >> bitcast<u32>(16i)))) - _e3056) * _e3018));
let _e3065 = (2i * (_e3016 + _e2978));
let _e3067 = (_e3065 >> bitcast<u32>(2i));
let _e3070 = bitcast<u32>(((_e3065 & 3i) * 8i));
let _e3072 = select(_e2326, _e3067, (_e3067 < _e2326));
let _e3077 = global_5.member[bitcast<u32>(select(0i, _e3072, (_e3072 > 0i)))];
let _e3081 = (_e3067 + 1i);
let _e3083 = select(_e2326, _e3081, (_e3081 < _e2326));
let _e3088 = global_5.member[bitcast<u32>(select(0i, _e3083, (_e3083 > 0i)))];
let _e3095 = ((_e3077 >> bitcast<u32>((_e3070 & 31u))) | ((_e3088 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3070) & 31u))));
let _e3098 = f32(bitcast<i32>((_e3095 & 65535u)));
let _e3106 = (_e3016 + _e3003);
let _e3107 = (2i * _e3106);
let _e3109 = (_e3107 >> bitcast<u32>(2i));
let _e3112 = bitcast<u32>(((_e3107 & 3i) * 8i));
let _e3114 = select(_e2326, _e3109, (_e3109 < _e2326));
let _e3119 = global_5.member[bitcast<u32>(select(0i, _e3114, (_e3114 > 0i)))];
let _e3123 = (_e3109 + 1i);
let _e3125 = select(_e2326, _e3123, (_e3123 < _e2326));
let _e3130 = global_5.member[bitcast<u32>(select(0i, _e3125, (_e3125 > 0i)))];
let _e3137 = ((_e3119 >> bitcast<u32>((_e3112 & 31u))) | ((_e3130 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3112) & 31u))));
let _e3140 = f32(bitcast<i32>((_e3137 & 65535u)));
let _e3147 = (_e3140 + ((f32(bitcast<i32>((_e3137 >> bitcast<u32>(16i)))) - _e3140) * _e3018));
let _e3149 = (2i * (_e3106 + _e2978));
let _e3151 = (_e3149 >> bitcast<u32>(2i));
let _e3154 = bitcast<u32>(((_e3149 & 3i) * 8i));
let _e3156 = select(_e2326, _e3151, (_e3151 < _e2326));
let _e3161 = global_5.member[bitcast<u32>(select(0i, _e3156, (_e3156 > 0i)))];
let _e3165 = (_e3151 + 1i);
let _e3167 = select(_e2326, _e3165, (_e3165 < _e2326));
let _e3172 = global_5.member[bitcast<u32>(select(0i, _e3167, (_e3167 > 0i)))];
let _e3179 = ((_e3161 >> bitcast<u32>((_e3154 & 31u))) | ((_e3172 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3154) & 31u))));
let _e3182 = f32(bitcast<i32>((_e3179 & 65535u)));
let _e3192 = (_e3063 + (((_e3098 + ((f32(bitcast<i32>((_e3095 >> bitcast<u32>(16i)))) - _e3098) * _e3018)) - _e3063) * _e3020));
phi_4466_ = (_e3192 + (((_e3147 + (((_e3182 + ((f32(bitcast<i32>((_e3179 >> bitcast<u32>(16i)))) - _e3182) * _e3018)) - _e3147) * _e3020)) - _e3192) * (_e2900 - f32(_e2945))));
} else {
phi_4466_ = 0f;
}
let _e3200 = phi_4466_;
let _e3201 = local_4;
let _e3202 = local_5[0u];
let _e3204 = local_5[1u];
let _e3206 = local_5[2u];
let _e3208 = ((_e3202 + 0f) - 0.5f);
let _e3209 = ((_e3204 + 1f) - 0.5f);
let _e3210 = ((_e3206 + 0f) - 0.5f);
let _e3212 = select(0f, _e3208, (_e3208 > 0f));
let _e3214 = select(_e2273, _e3212, (_e3212 < _e2273));
let _e3221 = select(0i, select(select(i32(_e3214), i32(-2147483648), (_e3214 < -2147483600f)), 2147483647i, (_e3214 > 2147483500f)), (_e3214 == _e3214));
let _e3225 = (_e3221 - select(0i, 1i, (_e3214 < f32(_e3221))));
let _e3227 = select(0f, _e3209, (_e3209 > 0f));
let _e3229 = select(_e2290, _e3227, (_e3227 < _e2290));
let _e3236 = select(0i, select(select(i32(_e3229), i32(-2147483648), (_e3229 < -2147483600f)), 2147483647i, (_e3229 > 2147483500f)), (_e3229 == _e3229));
let _e3240 = (_e3236 - select(0i, 1i, (_e3229 < f32(_e3236))));
let _e3242 = select(0f, _e3210, (_e3210 > 0f));
let _e3244 = select(_e2307, _e3242, (_e3242 < _e2307));
let _e3251 = select(0i, select(select(i32(_e3244), i32(-2147483648), (_e3244 < -2147483600f)), 2147483647i, (_e3244 > 2147483500f)), (_e3244 == _e3244));
let _e3255 = (_e3251 - select(0i, 1i, (_e3244 < f32(_e3251))));
let _e3256 = (_e3201 * 4i);
let _e3257 = (_e3256 + 1i);
let _e3259 = select(_e2326, _e3257, (_e3257 < _e2326));
let _e3264 = global_5.member[bitcast<u32>(select(0i, _e3259, (_e3259 > 0i)))];
let _e3265 = (_e3256 + 2i);
let _e3267 = select(_e2326, _e3265, (_e3265 < _e2326));
let _e3272 = global_5.member[bitcast<u32>(select(0i, _e3267, (_e3267 > 0i)))];
let _e3273 = (_e3256 + 3i);
let _e3275 = select(_e2326, _e3273, (_e3273 < _e2326));
let _e3280 = global_5.member[bitcast<u32>(select(0i, _e3275, (_e3275 > 0i)))];
let _e3283 = (_e3225 - bitcast<i32>((_e3264 & 65535u)));
let _e3288 = bitcast<i32>((_e3264 >> bitcast<u32>(16i)));
let _e3293 = (_e3240 - bitcast<i32>((_e3272 & 65535u)));
let _e3298 = bitcast<i32>((_e3272 >> bitcast<u32>(16i)));
let _e3303 = (_e3255 - bitcast<i32>((_e3280 & 65535u)));
if ((((_e3283 >= 0i) && ((_e3283 + 1i) < _e3288)) && ((_e3293 >= 0i) && ((_e3293 + 1i) < _e3298))) && ((_e3303 >= 0i) && ((_e3303 + 1i) < bitcast<i32>((_e3280 >> bitcast<u32>(16i)))))) {
let _e3313 = (_e3298 * _e3288);
let _e3315 = select(_e2326, _e3256, (_e3256 < _e2326));
let _e3320 = global_5.member[bitcast<u32>(select(0i, _e3315, (_e3315 > 0i)))];
let _e3326 = (((bitcast<i32>(_e3320) + (_e3303 * _e3313)) + (_e3293 * _e3288)) + _e3283);
let _e3328 = (_e3208 - f32(_e3225));
let _e3330 = (_e3209 - f32(_e3240));
let _e3333 = (2i * _e3326);
let _e3335 = (_e3333 >> bitcast<u32>(2i));
let _e3338 = bitcast<u32>(((_e3333 & 3i) * 8i));
let _e3340 = select(_e2326, _e3335, (_e3335 < _e2326));
let _e3345 = global_5.member[bitcast<u32>(select(0i, _e3340, (_e3340 > 0i)))];
let _e3349 = (_e3335 + 1i);
let _e3351 = select(_e2326, _e3349, (_e3349 < _e2326));
let _e3356 = global_5.member[bitcast<u32>(select(0i, _e3351, (_e3351 > 0i)))];
let _e3363 = ((_e3345 >> bitcast<u32>((_e3338 & 31u))) | ((_e3356 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3338) & 31u))));
let _e3366 = f32(bitcast<i32>((_e3363 & 65535u)));
let _e3373 = (_e3366 + ((f32(bitcast<i32>((_e3363 >> bitcast<u32>(16i)))) - _e3366) * _e3328));
let _e3375 = (2i * (_e3326 + _e3288));
let _e3377 = (_e3375 >> bitcast<u32>(2i));
let _e3380 = bitcast<u32>(((_e3375 & 3i) * 8i));
let _e3382 = select(_e2326, _e3377, (_e3377 < _e2326));
let _e3387 = global_5.member[bitcast<u32>(select(0i, _e3382, (_e3382 > 0i)))];
let _e3391 = (_e3377 + 1i);
let _e3393 = select(_e2326, _e3391, (_e3391 < _e2326));
let _e3398 = global_5.member[bitcast<u32>(select(0i, _e3393, (_e3393 > 0i)))];
let _e3405 = ((_e3387 >> bitcast<u32>((_e3380 & 31u))) | ((_e3398 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3380) & 31u))));
let _e3408 = f32(bitcast<i32>((_e3405 & 65535u)));
let _e3416 = (_e3326 + _e3313);
let _e3417 = (2i * _e3416);
let _e3419 = (_e3417 >> bitcast<u32>(2i));
let _e3422 = bitcast<u32>(((_e3417 & 3i) * 8i));
let _e3424 = select(_e2326, _e3419, (_e3419 < _e2326));
let _e3429 = global_5.member[bitcast<u32>(select(0i, _e3424, (_e3424 > 0i)))];
let _e3433 = (_e3419 + 1i);
let _e3435 = select(_e2326, _e3433, (_e3433 < _e2326));
let _e3440 = global_5.member[bitcast<u32>(select(0i, _e3435, (_e3435 > 0i)))];
let _e3447 = ((_e3429 >> bitcast<u32>((_e3422 & 31u))) | ((_e3440 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3422) & 31u))));
let _e3450 = f32(bitcast<i32>((_e3447 & 65535u)));
let _e3457 = (_e3450 + ((f32(bitcast<i32>((_e3447 >> bitcast<u32>(16i)))) - _e3450) * _e3328));
let _e3459 = (2i * (_e3416 + _e3288));
let _e3461 = (_e3459 >> bitcast<u32>(2i));
let _e3464 = bitcast<u32>(((_e3459 & 3i) * 8i));
let _e3466 = select(_e2326, _e3461, (_e3461 < _e2326));
let _e3471 = global_5.member[bitcast<u32>(select(0i, _e3466, (_e3466 > 0i)))];
let _e3475 = (_e3461 + 1i);
let _e3477 = select(_e2326, _e3475, (_e3475 < _e2326));
let _e3482 = global_5.member[bitcast<u32>(select(0i, _e3477, (_e3477 > 0i)))];
let _e3489 = ((_e3471 >> bitcast<u32>((_e3464 & 31u))) | ((_e3482 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3464) & 31u))));
let _e3492 = f32(bitcast<i32>((_e3489 & 65535u)));
let _e3502 = (_e3373 + (((_e3408 + ((f32(bitcast<i32>((_e3405 >> bitcast<u32>(16i)))) - _e3408) * _e3328)) - _e3373) * _e3330));
phi_4905_ = (_e3502 + (((_e3457 + (((_e3492 + ((f32(bitcast<i32>((_e3489 >> bitcast<u32>(16i)))) - _e3492) * _e3328)) - _e3457) * _e3330)) - _e3502) * (_e3210 - f32(_e3255))));
} else {
phi_4905_ = 0f;
}
let _e3510 = phi_4905_;
let _e3512 = local_4;
let _e3513 = local_5[0u];
let _e3515 = local_5[1u];
let _e3517 = local_5[2u];
let _e3519 = ((_e3513 + 0f) - 0.5f);
let _e3520 = ((_e3515 + 0f) - 0.5f);
let _e3521 = ((_e3517 + -1f) - 0.5f);
let _e3523 = select(0f, _e3519, (_e3519 > 0f));
let _e3525 = select(_e2273, _e3523, (_e3523 < _e2273));
let _e3532 = select(0i, select(select(i32(_e3525), i32(-2147483648), (_e3525 < -2147483600f)), 2147483647i, (_e3525 > 2147483500f)), (_e3525 == _e3525));
let _e3536 = (_e3532 - select(0i, 1i, (_e3525 < f32(_e3532))));
let _e3538 = select(0f, _e3520, (_e3520 > 0f));
let _e3540 = select(_e2290, _e3538, (_e3538 < _e2290));
let _e3547 = select(0i, select(select(i32(_e3540), i32(-2147483648), (_e3540 < -2147483600f)), 2147483647i, (_e3540 > 2147483500f)), (_e3540 == _e3540));
let _e3551 = (_e3547 - select(0i, 1i, (_e3540 < f32(_e3547))));
let _e3553 = select(0f, _e3521, (_e3521 > 0f));
let _e3555 = select(_e2307, _e3553, (_e3553 < _e2307));
let _e3562 = select(0i, select(select(i32(_e3555), i32(-2147483648), (_e3555 < -2147483600f)), 2147483647i, (_e3555 > 2147483500f)), (_e3555 == _e3555));
let _e3566 = (_e3562 - select(0i, 1i, (_e3555 < f32(_e3562))));
let _e3567 = (_e3512 * 4i);
let _e3568 = (_e3567 + 1i);
let _e3570 = select(_e2326, _e3568, (_e3568 < _e2326));
let _e3575 = global_5.member[bitcast<u32>(select(0i, _e3570, (_e3570 > 0i)))];
let _e3576 = (_e3567 + 2i);
let _e3578 = select(_e2326, _e3576, (_e3576 < _e2326));
let _e3583 = global_5.member[bitcast<u32>(select(0i, _e3578, (_e3578 > 0i)))];
let _e3584 = (_e3567 + 3i);
let _e3586 = select(_e2326, _e3584, (_e3584 < _e2326));
let _e3591 = global_5.member[bitcast<u32>(select(0i, _e3586, (_e3586 > 0i)))];
let _e3594 = (_e3536 - bitcast<i32>((_e3575 & 65535u)));
let _e3599 = bitcast<i32>((_e3575 >> bitcast<u32>(16i)));
let _e3604 = (_e3551 - bitcast<i32>((_e3583 & 65535u)));
let _e3609 = bitcast<i32>((_e3583 >> bitcast<u32>(16i)));
let _e3614 = (_e3566 - bitcast<i32>((_e3591 & 65535u)));
if ((((_e3594 >= 0i) && ((_e3594 + 1i) < _e3599)) && ((_e3604 >= 0i) && ((_e3604 + 1i) < _e3609))) && ((_e3614 >= 0i) && ((_e3614 + 1i) < bitcast<i32>((_e3591 >> bitcast<u32>(16i)))))) {
let _e3624 = (_e3609 * _e3599);
let _e3626 = select(_e2326, _e3567, (_e3567 < _e2326));
let _e3631 = global_5.member[bitcast<u32>(select(0i, _e3626, (_e3626 > 0i)))];
let _e3637 = (((bitcast<i32>(_e3631) + (_e3614 * _e3624)) + (_e3604 * _e3599)) + _e3594);
let _e3639 = (_e3519 - f32(_e3536));
let _e3641 = (_e3520 - f32(_e3551));
let _e3644 = (2i * _e3637);
let _e3646 = (_e3644 >> bitcast<u32>(2i));
let _e3649 = bitcast<u32>(((_e3644 & 3i) * 8i));
let _e3651 = select(_e2326, _e3646, (_e3646 < _e2326));
let _e3656 = global_5.member[bitcast<u32>(select(0i, _e3651, (_e3651 > 0i)))];
let _e3660 = (_e3646 + 1i);
let _e3662 = select(_e2326, _e3660, (_e3660 < _e2326));
let _e3667 = global_5.member[bitcast<u32>(select(0i, _e3662, (_e3662 > 0i)))];
let _e3674 = ((_e3656 >> bitcast<u32>((_e3649 & 31u))) | ((_e3667 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3649) & 31u))));
let _e3677 = f32(bitcast<i32>((_e3674 & 65535u)));
let _e3684 = (_e3677 + ((f32(bitcast<i32>((_e3674 >> bitcast<u32>(16i)))) - _e3677) * _e3639));
let _e3686 = (2i * (_e3637 + _e3599));
let _e3688 = (_e3686 >> bitcast<u32>(2i));
let _e3691 = bitcast<u32>(((_e3686 & 3i) * 8i));
let _e3693 = select(_e2326, _e3688, (_e3688 < _e2326));
let _e3698 = global_5.member[bitcast<u32>(select(0i, _e3693, (_e3693 > 0i)))];
let _e3702 = (_e3688 + 1i);
let _e3704 = select(_e2326, _e3702, (_e3702 < _e2326));
let _e3709 = global_5.member[bitcast<u32>(select(0i, _e3704, (_e3704 > 0i)))];
let _e3716 = ((_e3698 >> bitcast<u32>((_e3691 & 31u))) | ((_e3709 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3691) & 31u))));
let _e3719 = f32(bitcast<i32>((_e3716 & 65535u)));
let _e3727 = (_e3637 + _e3624);
let _e3728 = (2i * _e3727);
let _e3730 = (_e3728 >> bitcast<u32>(2i));
let _e3733 = bitcast<u32>(((_e3728 & 3i) * 8i));
let _e3735 = select(_e2326, _e3730, (_e3730 < _e2326));
let _e3740 = global_5.member[bitcast<u32>(select(0i, _e3735, (_e3735 > 0i)))];
let _e3744 = (_e3730 + 1i);
let _e3746 = select(_e2326, _e3744, (_e3744 < _e2326));
let _e3751 = global_5.member[bitcast<u32>(select(0i, _e3746, (_e3746 > 0i)))];
let _e3758 = ((_e3740 >> bitcast<u32>((_e3733 & 31u))) | ((_e3751 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3733) & 31u))));
let _e3761 = f32(bitcast<i32>((_e3758 & 65535u)));
let _e3768 = (_e3761 + ((f32(bitcast<i32>((_e3758 >> bitcast<u32>(16i)))) - _e3761) * _e3639));
let _e3770 = (2i * (_e3727 + _e3599));
let _e3772 = (_e3770 >> bitcast<u32>(2i));
let _e3775 = bitcast<u32>(((_e3770 & 3i) * 8i));
let _e3777 = select(_e2326, _e3772, (_e3772 < _e2326));
let _e3782 = global_5.member[bitcast<u32>(select(0i, _e3777, (_e3777 > 0i)))];
let _e3786 = (_e3772 + 1i);
let _e3788 = select(_e2326, _e3786, (_e3786 < _e2326));
let _e3793 = global_5.member[bitcast<u32>(select(0i, _e3788, (_e3788 > 0i)))];
let _e3800 = ((_e3782 >> bitcast<u32>((_e3775 & 31u))) | ((_e3793 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3775) & 31u))));
let _e3803 = f32(bitcast<i32>((_e3800 & 65535u)));
let _e3813 = (_e3684 + (((_e3719 + ((f32(bitcast<i32>((_e3716 >> bitcast<u32>(16i)))) - _e3719) * _e3639)) - _e3684) * _e3641));
phi_5345_ = (_e3813 + (((_e3768 + (((_e3803 + ((f32(bitcast<i32>((_e3800 >> bitcast<u32>(16i)))) - _e3803) * _e3639)) - _e3768) * _e3641)) - _e3813) * (_e3521 - f32(_e3566))));
} else {
phi_5345_ = 0f;
}
let _e3821 = phi_5345_;
let _e3822 = local_4;
let _e3823 = local_5[0u];
let _e3825 = local_5[1u];
let _e3827 = local_5[2u];
let _e3829 = ((_e3823 + 0f) - 0.5f);
let _e3830 = ((_e3825 + 0f) - 0.5f);
let _e3831 = ((_e3827 + 1f) - 0.5f);
let _e3833 = select(0f, _e3829, (_e3829 > 0f));
let _e3835 = select(_e2273, _e3833, (_e3833 < _e2273));
let _e3842 = select(0i, select(select(i32(_e3835), i32(-2147483648), (_e3835 < -2147483600f)), 2147483647i, (_e3835 > 2147483500f)), (_e3835 == _e3835));
let _e3846 = (_e3842 - select(0i, 1i, (_e3835 < f32(_e3842))));
let _e3848 = select(0f, _e3830, (_e3830 > 0f));
let _e3850 = select(_e2290, _e3848, (_e3848 < _e2290));
let _e3857 = select(0i, select(select(i32(_e3850), i32(-2147483648), (_e3850 < -2147483600f)), 2147483647i, (_e3850 > 2147483500f)), (_e3850 == _e3850));
let _e3861 = (_e3857 - select(0i, 1i, (_e3850 < f32(_e3857))));
let _e3863 = select(0f, _e3831, (_e3831 > 0f));
let _e3865 = select(_e2307, _e3863, (_e3863 < _e2307));
let _e3872 = select(0i, select(select(i32(_e3865), i32(-2147483648), (_e3865 < -2147483600f)), 2147483647i, (_e3865 > 2147483500f)), (_e3865 == _e3865));
let _e3876 = (_e3872 - select(0i, 1i, (_e3865 < f32(_e3872))));
let _e3877 = (_e3822 * 4i);
let _e3878 = (_e3877 + 1i);
let _e3880 = select(_e2326, _e3878, (_e3878 < _e2326));
let _e3885 = global_5.member[bitcast<u32>(select(0i, _e3880, (_e3880 > 0i)))];
let _e3886 = (_e3877 + 2i);
let _e3888 = select(_e2326, _e3886, (_e3886 < _e2326));
let _e3893 = global_5.member[bitcast<u32>(select(0i, _e3888, (_e3888 > 0i)))];
let _e3894 = (_e3877 + 3i);
let _e3896 = select(_e2326, _e3894, (_e3894 < _e2326));
let _e3901 = global_5.member[bitcast<u32>(select(0i, _e3896, (_e3896 > 0i)))];
let _e3904 = (_e3846 - bitcast<i32>((_e3885 & 65535u)));
let _e3909 = bitcast<i32>((_e3885 >> bitcast<u32>(16i)));
let _e3914 = (_e3861 - bitcast<i32>((_e3893 & 65535u)));
let _e3919 = bitcast<i32>((_e3893 >> bitcast<u32>(16i)));
let _e3924 = (_e3876 - bitcast<i32>((_e3901 & 65535u)));
if ((((_e3904 >= 0i) && ((_e3904 + 1i) < _e3909)) && ((_e3914 >= 0i) && ((_e3914 + 1i) < _e3919))) && ((_e3924 >= 0i) && ((_e3924 + 1i) < bitcast<i32>((_e3901 >> bitcast<u32>(16i)))))) {
let _e3934 = (_e3919 * _e3909);
let _e3936 = select(_e2326, _e3877, (_e3877 < _e2326));
let _e3941 = global_5.member[bitcast<u32>(select(0i, _e3936, (_e3936 > 0i)))];
let _e3947 = (((bitcast<i32>(_e3941) + (_e3924 * _e3934)) + (_e3914 * _e3909)) + _e3904);
let _e3949 = (_e3829 - f32(_e3846));
let _e3951 = (_e3830 - f32(_e3861));
let _e3954 = (2i * _e3947);
let _e3956 = (_e3954 >> bitcast<u32>(2i));
let _e3959 = bitcast<u32>(((_e3954 & 3i) * 8i));
let _e3961 = select(_e2326, _e3956, (_e3956 < _e2326));
let _e3966 = global_5.member[bitcast<u32>(select(0i, _e3961, (_e3961 > 0i)))];
let _e3970 = (_e3956 + 1i);
let _e3972 = select(_e2326, _e3970, (_e3970 < _e2326));
let _e3977 = global_5.member[bitcast<u32>(select(0i, _e3972, (_e3972 > 0i)))];
let _e3984 = ((_e3966 >> bitcast<u32>((_e3959 & 31u))) | ((_e3977 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3959) & 31u))));
let _e3987 = f32(bitcast<i32>((_e3984 & 65535u)));
let _e3994 = (_e3987 + ((f32(bitcast<i32>((_e3984 >> bitcast<u32>(16i)))) - _e3987) * _e3949));
let _e3996 = (2i * (_e3947 + _e3909));
let _e3998 = (_e3996 >> bitcast<u32>(2i));
let _e4001 = bitcast<u32>(((_e3996 & 3i) * 8i));
let _e4003 = select(_e2326, _e3998, (_e3998 < _e2326));
let _e4008 = global_5.member[bitcast<u32>(select(0i, _e4003, (_e4003 > 0i)))];
let _e4012 = (_e3998 + 1i);
let _e4014 = select(_e2326, _e4012, (_e4012 < _e2326));
let _e4019 = global_5.member[bitcast<u32>(select(0i, _e4014, (_e4014 > 0i)))];
let _e4026 = ((_e4008 >> bitcast<u32>((_e4001 & 31u))) | ((_e4019 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e4001) & 31u))));
let _e4029 = f32(bitcast<i32>((_e4026 & 65535u)));
let _e4037 = (_e3947 + _e3934);
let _e4038 = (2i * _e4037);
let _e4040 = (_e4038 >> bitcast<u32>(2i));
let _e4043 = bitcast<u32>(((_e4038 & 3i) * 8i));
let _e4045 = select(_e2326, _e4040, (_e4040 < _e2326));
let _e4050 = global_5.member[bitcast<u32>(select(0i, _e4045, (_e4045 > 0i)))];
let _e4054 = (_e4040 + 1i);
let _e4056 = select(_e2326, _e4054, (_e4054 < _e2326));
let _e4061 = global_5.member[bitcast<u32>(select(0i, _e4056, (_e4056 > 0i)))];
let _e4068 = ((_e4050 >> bitcast<u32>((_e4043 & 31u))) | ((_e4061 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e4043) & 31u))));
let _e4071 = f32(bitcast<i32>((_e4068 & 65535u)));
let _e4078 = (_e4071 + ((f32(bitcast<i32>((_e4068 >> bitcast<u32>(16i)))) - _e4071) * _e3949));
let _e4080 = (2i * (_e4037 + _e3909));
let _e4082 = (_e4080 >> bitcast<u32>(2i));
let _e4085 = bitcast<u32>(((_e4080 & 3i) * 8i));
let _e4087 = select(_e2326, _e4082, (_e4082 < _e2326));
let _e4092 = global_5.member[bitcast<u32>(select(0i, _e4087, (_e4087 > 0i)))];
let _e4096 = (_e4082 + 1i);
let _e4098 = select(_e2326, _e4096, (_e4096 < _e2326));
let _e4103 = global_5.member[bitcast<u32>(select(0i, _e4098, (_e4098 > 0i)))];
let _e4110 = ((_e4092 >> bitcast<u32>((_e4085 & 31u))) | ((_e4103 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e4085) & 31u))));
let _e4113 = f32(bitcast<i32>((_e4110 & 65535u)));
let _e4123 = (_e3994 + (((_e4029 + ((f32(bitcast<i32>((_e4026 >> bitcast<u32>(16i)))) - _e4029) * _e3949)) - _e3994) * _e3951));
phi_5784_ = (_e4123 + (((_e4078 + (((_e4113 + ((f32(bitcast<i32>((_e4110 >> bitcast<u32>(16i)))) - _e4113) * _e3949)) - _e4078) * _e3951)) - _e4123) * (_e3831 - f32(_e3876))));
} else {
phi_5784_ = 0f;
}
let _e4131 = phi_5784_;
let _e4133 = (0.5f / 5461.25f);
let _e4134 = ((_e2579 - _e2889) * _e4133);
let _e4135 = ((_e3200 - _e3510) * _e4133);
let _e4136 = ((_e3821 - _e4131) * _e4133);
let _e4141 = (((_e4134 * _e4134) + (_e4135 * _e4135)) + (_e4136 * _e4136));
let _e4144 = sqrt(select(0f, _e4141, (_e4141 > 0f)));
let _e4147 = (1f / select(1e-6f, _e4144, (_e4144 > 1e-6f)));
let _e4148 = (_e4134 * _e4147);
let _e4149 = (_e4135 * _e4147);
let _e4150 = (_e4136 * _e4147);
let _e4151 = vec3<f32>(_e4148, _e4149, _e4150);
if (_e4144 >= 0.998f) {
phi_12206_ = type_28(_e4151, 0f);
} else {
let _e4160 = bitcast<f32>((bitcast<u32>(_e4148) & 2147483647u));
let _e4163 = bitcast<f32>((bitcast<u32>(_e4149) & 2147483647u));
let _e4166 = bitcast<f32>((bitcast<u32>(_e4150) & 2147483647u));
if ((_e4160 <= _e4163) && (_e4160 <= _e4166)) {
phi_5847_ = vec3<f32>(1f, 0f, 0f);
} else {
phi_5847_ = select(vec3<f32>(0f, 0f, 1f), vec3<f32>(0f, 1f, 0f), vec3((_e4163 <= _e4166)));
}
let _e4174 = phi_5847_;
let _e4179 = ((_e4149 * _e4174.z) - (_e4150 * _e4174.y));
let _e4183 = ((_e4150 * _e4174.x) - (_e4148 * _e4174.z));
let _e4186 = ((_e4148 * _e4174.y) - (_e4149 * _e4174.x));
let _e4191 = (((_e4179 * _e4179) + (_e4183 * _e4183)) + (_e4186 * _e4186));
let _e4194 = sqrt(select(0f, _e4191, (_e4191 > 0f)));
let _e4197 = (1f / select(1e-20f, _e4194, (_e4194 > 1e-20f)));
let _e4198 = (_e4179 * _e4197);
let _e4199 = (_e4183 * _e4197);
let _e4200 = (_e4186 * _e4197);
phi_5894_ = 0f;
phi_5897_ = 4f;
phi_5899_ = 0i;
phi_5901_ = 1f;
phi_5903_ = type_28(_e4151, 0f);
loop {
let _e4212 = phi_5894_;
let _e4214 = phi_5897_;
let _e4216 = phi_5899_;
let _e4218 = phi_5901_;
let _e4220 = phi_5903_;
local_54 = _e4220;
let _e4221 = (_e4216 < 8i);
if _e4221 {
let _e4234 = (_e1885 + (((_e4198 * _e4218) + (((_e4149 * _e4200) - (_e4150 * _e4199)) * _e4212)) * 6f));
let _e4235 = (_e1886 + (((_e4199 * _e4218) + (((_e4150 * _e4198) - (_e4148 * _e4200)) * _e4212)) * 6f));
let _e4236 = (_e1887 + (((_e4200 * _e4218) + (((_e4148 * _e4199) - (_e4149 * _e4198)) * _e4212)) * 6f));
local_2 = _e2246;
local_3 = vec3<f32>(_e4234, _e4235, _e4236);
let _e4241 = local_2;
let _e4242 = local_3[0u];
let _e4244 = local_3[1u];
let _e4246 = local_3[2u];
let _e4248 = ((_e4242 + -1f) - 0.5f);
let _e4249 = ((_e4244 + 0f) - 0.5f);
let _e4250 = ((_e4246 + 0f) - 0.5f);
let _e4252 = select(0f, _e4248, (_e4248 > 0f));
let _e4254 = select(_e2273, _e4252, (_e4252 < _e2273));
let _e4261 = select(0i, select(select(i32(_e4254), i32(-2147483648), (_e4254 < -2147483600f)), 2147483647i, (_e4254 > 2147483500f)), (_e4254 == _e4254));
let _e4265 = (_e4261 - select(0i, 1i, (_e4254 < f32(_e4261))));
let _e4267 = select(0f, _e4249, (_e4249 > 0f));
let _e4269 = select(_e2290, _e4267, (_e4267 < _e2290));
let _e4276 = select(0i, select(select(i32(_e4269), i32(-2147483648), (_e4269 < -2147483600f)), 2147483647i, (_e4269 > 2147483500f)), (_e4269 == _e4269));
let _e4280 = (_e4276 - select(0i, 1i, (_e4269 < f32(_e4276))));
let _e4282 = select(0f, _e4250, (_e4250 > 0f));
let _e4284 = select(_e2307, _e4282, (_e4282 < _e2307));
let _e4291 = select(0i, select(select(i32(_e4284), i32(-2147483648), (_e4284 < -2147483600f)), 2147483647i, (_e4284 > 2147483500f)), (_e4284 == _e4284));
let _e4295 = (_e4291 - select(0i, 1i, (_e4284 < f32(_e4291))));
let _e4296 = (_e4241 * 4i);
let _e4297 = (_e4296 + 1i);
let _e4299 = select(_e2326, _e4297, (_e4297 < _e2326));
let _e4304 = global_5.member[bitcast<u32>(select(0i, _e4299, (_e4299 > 0i)))];
let _e4305 = (_e4296 + 2i);
let _e4307 = select(_e2326, _e4305, (_e4305 < _e2326));
let _e4312 = global_5.member[bitcast<u32>(select(0i, _e4307, (_e4307 > 0i)))];
let _e4313 = (_e4296 + 3i);
let _e4315 = select(_e2326, _e4313, (_e4313 < _e2326));
let _e4320 = global_5.member[bitcast<u32>(select(0i, _e4315, (_e4315 > 0i)))];
let _e4323 = (_e4265 - bitcast<i32>((_e4304 & 65535u)));
let _e4328 = bitcast<i32>((_e4304 >> bitcast<u32>(16i)));
let _e4333 = (_e4280 - bitcast<i32>((_e4312 & 65535u)));
let _e4338 = bitcast<i32>((_e4312 >> bitcast<u32>(16i)));
let _e4343 = (_e4295 - bitcast<i32>((_e4320 & 65535u)));
if ((((_e4323 >= 0i) && ((_e4323 + 1i) < _e4328)) && ((_e4333 >= 0i) && ((_e4333 + 1i) < _e4338))) && ((_e4343 >= 0i) && ((_e4343 + 1i) < bitcast<i32>((_e4320 >> bitcast<u32>(16i)))))) {
let _e4353 = (_e4338 * _e4328);
let _e4355 = select(_e2326, _e4296, (_e4296 < _e2326));
let _e4360 = global_5.member[bitcast<u32>(select(0i, _e4355, (_e4355 > 0i)))];
let _e4366 = (((bitcast<i32>(_e4360) + (_e4343 * _e4353)) + (_e4333 * _e4328)) + _e4323);
let _e4368 = (_e4248 - f32(_e4265));
let _e4370 = (_e4249 - f32(_e4280));
let _e4373 = (2i * _e4366);
let _e4375 = (_e4373 >> bitcast<u32>(2i));
let _e4378 = bitcast<u32>(((_e4373 & 3i) * 8i));
let _e4380 = select(_e2326, _e4375, (_e4375 < _e2326));
let _e4385 = global_5.member[bitcast<u32>(select(0i, _e4380, (_e4380 > 0i)))];
let _e4389 = (_e4375 + 1i);
let _e4391 = select(_e2326, _e4389, (_e4389 < _e2326));
let _e4396 = global_5.member[bitcast<u32>(select(0i, _e4391, (_e4391 > 0i)))];
let _e4403 = ((_e4385 >> bitcast<u32>((_e4378 & 31u))) | ((_e4396 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e4378) & 31u))));
let _e4406 = f32(bitcast<i32>((_e4403 & 65535u)));
let _e4413 = (_e4406 + ((f32(bitcast<i32>((_e4403 >> bitcast<u32>(16i)))) - _e4406) * _e4368));
let _e4415 = (2i * (_e4366 + _e4328));
let _e4417 = (_e4415 >> bitcast<u32>(2i));
let _e4420 = bitcast<u32>(((_e4415 & 3i) * 8i));
let _e4422 = select(_e2326, _e4417, (_e4417 < _e2326));
let _e4427 = global_5.member[bitcast<u32>(select(0i, _e4422, (_e4422 > 0i)))];
let _e4431 = (_e4417 + 1i);
let _e4433 = select(_e2326, _e4431, (_e4431 < _e2326));
let _e4438 = global_5.member[bitcast<u32>(select(0i, _e4433, (_e4433 > 0i)))];
let _e4445 = ((_e4427 >> bitcast<u32>((_e4420 & 31u))) | ((_e4438 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e4420) & 31u))));
let _e4448 = f32(bitcast<i32>((_e4445 & 65535u)));
let _e4456 = (_e4366 + _e4353);
let _e4457 = (2i * _e4456);
let _e4459 = (_e4457 >> bitcast<u32>(2i));
let _e4462 = bitcast<u32>(((_e4457 & 3i) * 8i));
let _e4464 = select(_e2326, _e4459, (_e4459 < _e2326));
let _e4469 = global_5.member[bitcast<u32>(select(0i, _e4464, (_e4464 > 0i)))];
let _e4473 = (_e4459 + 1i);
let _e4475 = select(_e2326, _e4473, (_e4473 < _e2326));
let _e4480 = global_5.member[bitcast<u32>(select(0i, _e4475, (_e4475 > 0i)))];
let _e4487 = ((_e4469 >> bitcast<u32>((_e4462 & 31u))) | ((_e4480 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e4462) & 31u))));
let _e4490 = f32(bitcast<i32>((_e4487 & 65535u)));
let _e4497 = (_e4490 + ((f32(bitcast<i32>((_e4487 >> bitcast<u32>(16i)))) - _e4490) * _e4368));
let _e4499 = (2i * (_e4456 + _e4328));
let _e4501 = (_e4499 >> bitcast<u32>(2i));
let _e4504 = bitcast<u32>(((_e4499 & 3i) * 8i));
let _e4506 = select(_e2326, _e4501, (_e4501 < _e2326));
let _e4511 = global_5.member[bitcast<u32>(select(0i, _e4506, (_e4506 > 0i)))];
let _e4515 = (_e4501 + 1i);
let _e4517 = select(_e2326, _e4515, (_e4515 < _e2326));
let _e4522 = global_5.member[bitcast<u32>(select(0i, _e4517, (_e4517 > 0i)))];
let _e4529 = ((_e4511 >> bitcast<u32>((_e4504 & 31u))) | ((_e4522 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e4504) & 31u))));
let _e4532 = f32(bitcast<i32>((_e4529 & 65535u)));
let _e4542 = (_e4413 + (((_e4448 + ((f32(bitcast<i32>((_e4445 >> bitcast<u32>(16i)))) - _e4448) * _e4368)) - _e4413) * _e4370));
phi_6375_ = (_e4542 + (((_e4497 + (((_e4532 + ((f32(bitcast<i32>((_e4529 >> bitcast<u32>(16i)))) - _e4532) * _e4368)) - _e4497) * _e4370)) - _e4542) * (_e4250 - f32(_e4295))));
} else {
phi_6375_ = 0f;
}
let _e4550 = phi_6375_;
let _e4551 = local_2;
let _e4552 = local_3[0u];
let _e4554 = local_3[1u];
let _e4556 = local_3[2u];
let _e4558 = ((_e4552 + 1f) - 0.5f);
let _e4559 = ((_e4554 + 0f) - 0.5f);
let _e4560 = ((_e4556 + 0f) - 0.5f);
let _e4562 = select(0f, _e4558, (_e4558 > 0f));
let _e4564 = select(_e2273, _e4562, (_e4562 < _e2273));
let _e4571 = select(0i, select(select(i32(_e4564), i32(-2147483648), (_e4564 < -2147483600f)), 2147483647i, (_e4564 > 2147483500f)), (_e4564 == _e4564));
let _e4575 = (_e4571 - select(0i, 1i, (_e4564 < f32(_e4571))));
let _e4577 = select(0f, _e4559, (_e4559 > 0f));
let _e4579 = select(_e2290, _e4577, (_e4577 < _e2290));
let _e4586 = select(0i, select(select(i32(_e4579), i32(-2147483648), (_e4579 < -2147483600f)), 2147483647i, (_e4579 > 2147483500f)), (_e4579 == _e4579));
let _e4590 = (_e4586 - select(0i, 1i, (_e4579 < f32(_e4586))));
let _e4592 = select(0f, _e4560, (_e4560 > 0f));
let _e4594 = select(_e2307, _e4592, (_e4592 < _e2307));
let _e4601 = select(0i, select(select(i32(_e4594), i32(-2147483648), (_e4594 < -2147483600f)), 2147483647i, (_e4594 > 2147483500f)), (_e4594 == _e4594));
let _e4605 = (_e4601 - select(0i, 1i, (_e4594 < f32(_e4601))));
let _e4606 = (_e4551 * 4i);
let _e4607 = (_e4606 + 1i);
let _e4609 = select(_e2326, _e4607, (_e4607 < _e2326));
let _e4614 = global_5.member[bitcast<u32>(select(0i, _e4609, (_e4609 > 0i)))];
let _e4615 = (_e4606 + 2i);
let _e4617 = select(_e2326, _e4615, (_e4615 < _e2326));
let _e4622 = global_5.member[bitcast<u32>(select(0i, _e4617, (_e4617 > 0i)))];
let _e4623 = (_e4606 + 3i);
let _e4625 = select(_e2326, _e4623, (_e4623 < _e2326));
let _e4630 = global_5.member[bitcast<u32>(select(0i, _e4625, (_e4625 > 0i)))];
let _e4633 = (_e4575 - bitcast<i32>((_e4614 & 65535u)));
let _e4638 = bitcast<i32>((_e4614 >> bitcast<u32>(16i)));
let _e4643 = (_e4590 - bitcast<i32>((_e4622 & 65535u)));
let _e4648 = bitcast<i32>((_e4622 >> bitcast<u32>(16i)));
let _e4653 = (_e4605 - bitcast<i32>((_e4630 & 65535u)));
if ((((_e4633 >= 0i) && ((_e4633 + 1i) < _e4638)) && ((_e4643 >= 0i) && ((_e4643 + 1i) < _e4648))) && ((_e4653 >= 0i) && ((_e4653 + 1i) < bitcast<i32>((_e4630 >> bitcast<u32>(16i)))))) {
let _e4663 = (_e4648 * _e4638);
let _e4665 = select(_e2326, _e4606, (_e4606 < _e2326));
let _e4670 = global_5.member[bitcast<u32>(select(0i, _e4665, (_e4665 > 0i)))];
let _e4676 = (((bitcast<i32>(_e4670) + (_e4653 * _e4663)) + (_e4643 * _e4638)) + _e4633);
let _e4678 = (_e4558 - f32(_e4575));
let _e4680 = (_e4559 - f32(_e4590));
let _e4683 = (2i * _e4676);
let _e4685 = (_e4683 >> bitcast<u32>(2i));
let _e4688 = bitcast<u32>(((_e4683 & 3i) * 8i));
let _e4690 = select(_e2326, _e4685, (_e4685 < _e2326));
let _e4695 = global_5.member[bitcast<u32>(select(0i, _e4690, (_e4690 > 0i)))];
let _e4699 = (_e4685 + 1i);
let _e4701 = select(_e2326, _e4699, (_e4699 < _e2326));
let _e4706 = global_5.member[bitcast<u32>(select(0i, _e4701, (_e4701 > 0i)))];
let _e4713 = ((_e4695 >> bitcast<u32>((_e4688 & 31u))) | ((_e4706 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e4688) & 31u))));
let _e4716 = f32(bitcast<i32>((_e4713 & 65535u)));
let _e4723 = (_e4716 + ((f32(bitcast<i32>((_e4713 >> bitcast<u32>(16i)))) - _e4716) * _e4678));
let _e4725 = (2i * (_e4676 + _e4638));
let _e4727 = (_e4725 >> bitcast<u32>(2i));
let _e4730 = bitcast<u32>(((_e4725 & 3i) * 8i));
let _e4732 = select(_e2326, _e4727, (_e4727 < _e2326));
let _e4737 = global_5.member[bitcast<u32>(select(0i, _e4732, (_e4732 > 0i)))];
let _e4741 = (_e4727 + 1i);
let _e4743 = select(_e2326, _e4741, (_e4741 < _e2326));
let _e4748 = global_5.member[bitcast<u32>(select(0i, _e4743, (_e4743 > 0i)))];
let _e4755 = ((_e4737 >> bitcast<u32>((_e4730 & 31u))) | ((_e4748 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e4730) & 31u))));
let _e4758 = f32(bitcast<i32>((_e4755 & 65535u)));
let _e4766 = (_e4676 + _e4663);
let _e4767 = (2i * _e4766);
let _e4769 = (_e4767 >> bitcast<u32>(2i));
let _e4772 = bitcast<u32>(((_e4767 & 3i) * 8i));
let _e4774 = select(_e2326, _e4769, (_e4769 < _e2326));
let _e4779 = global_5.member[bitcast<u32>(select(0i, _e4774, (_e4774 > 0i)))];
let _e4783 = (_e4769 + 1i);
let _e4785 = select(_e2326, _e4783, (_e4783 < _e2326));
let _e4790 = global_5.member[bitcast<u32>(select(0i, _e4785, (_e4785 > 0i)))];
let _e4797 = ((_e4779 >> bitcast<u32>((_e4772 & 31u))) | ((_e4790 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e4772) & 31u))));
let _e4800 = f32(bitcast<i32>((_e4797 & 65535u)));
let _e4807 = (_e4800 + ((f32(bitcast<i32>((_e4797 >> bitcast<u32>(16i)))) - _e4800) * _e4678));
let _e4809 = (2i * (_e4766 + _e4638));
let _e4811 = (_e4809 >> bitcast<u32>(2i));
let _e4814 = bitcast<u32>(((_e4809 & 3i) * 8i));
let _e4816 = select(_e2326, _e4811, (_e4811 < _e2326));
let _e4821 = global_5.member[bitcast<u32>(select(0i, _e4816, (_e4816 > 0i)))];
let _e4825 = (_e4811 + 1i);
let _e4827 = select(_e2326, _e4825, (_e4825 < _e2326));
let _e4832 = global_5.member[bitcast<u32>(select(0i, _e4827, (_e4827 > 0i)))];
let _e4839 = ((_e4821 >> bitcast<u32>((_e4814 & 31u))) | ((_e4832 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e4814) & 31u))));
let _e4842 = f32(bitcast<i32>((_e4839 & 65535u)));
let _e4852 = (_e4723 + (((_e4758 + ((f32(bitcast<i32>((_e4755 >> bitcast<u32>(16i)))) - _e4758) * _e4678)) - _e4723) * _e4680));
phi_6814_ = (_e4852 + (((_e4807 + (((_e4842 + ((f32(bitcast<i32>((_e4839 >> bitcast<u32>(16i)))) - _e4842) * _e4678)) - _e4807) * _e4680)) - _e4852) * (_e4560 - f32(_e4605))));
} else {
phi_6814_ = 0f;
}
let _e4860 = phi_6814_;
let _e4862 = local_2;
let _e4863 = local_3[0u];
let _e4865 = local_3[1u];
let _e4867 = local_3[2u];
let _e4869 = ((_e4863 + 0f) - 0.5f);
let _e4870 = ((_e4865 + -1f) - 0.5f);
let _e4871 = ((_e4867 + 0f) - 0.5f);
let _e4873 = select(0f, _e4869, (_e4869 > 0f));
let _e4875 = select(_e2273, _e4873, (_e4873 < _e2273));
let _e4882 = select(0i, select(select(i32(_e4875), i32(-2147483648), (_e4875 < -2147483600f)), 2147483647i, (_e4875 > 2147483500f)), (_e4875 == _e4875));
let _e4886 = (_e4882 - select(0i, 1i, (_e4875 < f32(_e4882))));
let _e4888 = select(0f, _e4870, (_e4870 > 0f));
let _e4890 = select(_e2290, _e4888, (_e4888 < _e2290));
let _e4897 = select(0i, select(select(i32(_e4890), i32(-2147483648), (_e4890 < -2147483600f)), 2147483647i, (_e4890 > 2147483500f)), (_e4890 == _e4890));
let _e4901 = (_e4897 - select(0i, 1i, (_e4890 < f32(_e4897))));
let _e4903 = select(0f, _e4871, (_e4871 > 0f));
let _e4905 = select(_e2307, _e4903, (_e4903 < _e2307));
let _e4912 = select(0i, select(select(i32(_e4905), i32(-2147483648), (_e4905 < -2147483600f)), 2147483647i, (_e4905 > 2147483500f)), (_e4905 == _e4905));
let _e4916 = (_e4912 - select(0i, 1i, (_e4905 < f32(_e4912))));
let _e4917 = (_e4862 * 4i);
let _e4918 = (_e4917 + 1i);
let _e4920 = select(_e2326, _e4918, (_e4918 < _e2326));
let _e4925 = global_5.member[bitcast<u32>(select(0i, _e4920, (_e4920 > 0i)))];
let _e4926 = (_e4917 + 2i);
let _e4928 = select(_e2326, _e4926, (_e4926 < _e2326));
let _e4933 = global_5.member[bitcast<u32>(select(0i, _e4928, (_e4928 > 0i)))];
let _e4934 = (_e4917 + 3i);
let _e4936 = select(_e2326, _e4934, (_e4934 < _e2326));
let _e4941 = global_5.member[bitcast<u32>(select(0i, _e4936, (_e4936 > 0i)))];
let _e4944 = (_e4886 - bitcast<i32>((_e4925 & 65535u)));
let _e4949 = bitcast<i32>((_e4925 >> bitcast<u32>(16i)));
let _e4954 = (_e4901 - bitcast<i32>((_e4933 & 65535u)));
let _e4959 = bitcast<i32>((_e4933 >> bitcast<u32>(16i)));
let _e4964 = (_e4916 - bitcast<i32>((_e4941 & 65535u)));
if ((((_e4944 >= 0i) && ((_e4944 + 1i) < _e4949)) && ((_e4954 >= 0i) && ((_e4954 + 1i) < _e4959))) && ((_e4964 >= 0i) && ((_e4964 + 1i) < bitcast<i32>((_e4941 >> bitcast<u32>(16i)))))) {
let _e4974 = (_e4959 * _e4949);
let _e4976 = select(_e2326, _e4917, (_e4917 < _e2326));
let _e4981 = global_5.member[bitcast<u32>(select(0i, _e4976, (_e4976 > 0i)))];
let _e4987 = (((bitcast<i32>(_e4981) + (_e4964 * _e4974)) + (_e4954 * _e4949)) + _e4944);
let _e4989 = (_e4869 - f32(_e4886));
let _e4991 = (_e4870 - f32(_e4901));
let _e4994 = (2i * _e4987);
let _e4996 = (_e4994 >> bitcast<u32>(2i));
let _e4999 = bitcast<u32>(((_e4994 & 3i) * 8i));
let _e5001 = select(_e2326, _e4996, (_e4996 < _e2326));
let _e5006 = global_5.member[bitcast<u32>(select(0i, _e5001, (_e5001 > 0i)))];
let _e5010 = (_e4996 + 1i);
let _e5012 = select(_e2326, _e5010, (_e5010 < _e2326));
let _e5017 = global_5.member[bitcast<u32>(select(0i, _e5012, (_e5012 > 0i)))];
let _e5024 = ((_e5006 >> bitcast<u32>((_e4999 & 31u))) | ((_e5017 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e4999) & 31u))));
let _e5027 = f32(bitcast<i32>((_e5024 & 65535u)));
let _e5034 = (_e5027 + ((f32(bitcast<i32>((_e5024 >> bitcast<u32>(16i)))) - _e5027) * _e4989));
let _e5036 = (2i * (_e4987 + _e4949));
let _e5038 = (_e5036 >> bitcast<u32>(2i));
let _e5041 = bitcast<u32>(((_e5036 & 3i) * 8i));
let _e5043 = select(_e2326, _e5038, (_e5038 < _e2326));
let _e5048 = global_5.member[bitcast<u32>(select(0i, _e5043, (_e5043 > 0i)))];
let _e5052 = (_e5038 + 1i);
let _e5054 = select(_e2326, _e5052, (_e5052 < _e2326));
let _e5059 = global_5.member[bitcast<u32>(select(0i, _e5054, (_e5054 > 0i)))];
let _e5066 = ((_e5048 >> bitcast<u32>((_e5041 & 31u))) | ((_e5059 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e5041) & 31u))));
let _e5069 = f32(bitcast<i32>((_e5066 & 65535u)));
let _e5077 = (_e4987 + _e4974);
let _e5078 = (2i * _e5077);
let _e5080 = (_e5078 >> bitcast<u32>(2i));
let _e5083 = bitcast<u32>(((_e5078 & 3i) * 8i));
let _e5085 = select(_e2326, _e5080, (_e5080 < _e2326));
let _e5090 = global_5.member[bitcast<u32>(select(0i, _e5085, (_e5085 > 0i)))];
let _e5094 = (_e5080 + 1i);
let _e5096 = select(_e2326, _e5094, (_e5094 < _e2326));
let _e5101 = global_5.member[bitcast<u32>(select(0i, _e5096, (_e5096 > 0i)))];
let _e5108 = ((_e5090 >> bitcast<u32>((_e5083 & 31u))) | ((_e5101 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e5083) & 31u))));
let _e5111 = f32(bitcast<i32>((_e5108 & 65535u)));
let _e5118 = (_e5111 + ((f32(bitcast<i32>((_e5108 >> bitcast<u32>(16i)))) - _e5111) * _e4989));
let _e5120 = (2i * (_e5077 + _e4949));
let _e5122 = (_e5120 >> bitcast<u32>(2i));
let _e5125 = bitcast<u32>(((_e5120 & 3i) * 8i));
let _e5127 = select(_e2326, _e5122, (_e5122 < _e2326));
let _e5132 = global_5.member[bitcast<u32>(select(0i, _e5127, (_e5127 > 0i)))];
let _e5136 = (_e5122 + 1i);
let _e5138 = select(_e2326, _e5136, (_e5136 < _e2326));
let _e5143 = global_5.member[bitcast<u32>(select(0i, _e5138, (_e5138 > 0i)))];
let _e5150 = ((_e5132 >> bitcast<u32>((_e5125 & 31u))) | ((_e5143 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e5125) & 31u))));
let _e5153 = f32(bitcast<i32>((_e5150 & 65535u)));
let _e5163 = (_e5034 + (((_e5069 + ((f32(bitcast<i32>((_e5066 >> bitcast<u32>(16i)))) - _e5069) * _e4989)) - _e5034) * _e4991));
phi_7254_ = (_e5163 + (((_e5118 + (((_e5153 + ((f32(bitcast<i32>((_e5150 >> bitcast<u32>(16i)))) - _e5153) * _e4989)) - _e5118) * _e4991)) - _e5163) * (_e4871 - f32(_e4916))));
} else {
phi_7254_ = 0f;
}
let _e5171 = phi_7254_;
let _e5172 = local_2;
let _e5173 = local_3[0u];
let _e5175 = local_3[1u];
let _e5177 = local_3[2u];
let _e5179 = ((_e5173 + 0f) - 0.5f);
let _e5180 = ((_e5175 + 1f) - 0.5f);
let _e5181 = ((_e5177 + 0f) - 0.5f);
let _e5183 = select(0f, _e5179, (_e5179 > 0f));
let _e5185 = select(_e2273, _e5183, (_e5183 < _e2273));
let _e5192 = select(0i, select(select(i32(_e5185), i32(-2147483648), (_e5185 < -2147483600f)), 2147483647i, (_e5185 > 2147483500f)), (_e5185 == _e5185));
let _e5196 = (_e5192 - select(0i, 1i, (_e5185 < f32(_e5192))));
let _e5198 = select(0f, _e5180, (_e5180 > 0f));
let _e5200 = select(_e2290, _e5198, (_e5198 < _e2290));
let _e5207 = select(0i, select(select(i32(_e5200), i32(-2147483648), (_e5200 < -2147483600f)), 2147483647i, (_e5200 > 2147483500f)), (_e5200 == _e5200));
let _e5211 = (_e5207 - select(0i, 1i, (_e5200 < f32(_e5207))));
let _e5213 = select(0f, _e5181, (_e5181 > 0f));
let _e5215 = select(_e2307, _e5213, (_e5213 < _e2307));
let _e5222 = select(0i, select(select(i32(_e5215), i32(-2147483648), (_e5215 < -2147483600f)), 2147483647i, (_e5215 > 2147483500f)), (_e5215 == _e5215));
let _e5226 = (_e5222 - select(0i, 1i, (_e5215 < f32(_e5222))));
let _e5227 = (_e5172 * 4i);
let _e5228 = (_e5227 + 1i);
let _e5230 = select(_e2326, _e5228, (_e5228 < _e2326));
let _e5235 = global_5.member[bitcast<u32>(select(0i, _e5230, (_e5230 > 0i)))];
let _e5236 = (_e5227 + 2i);
let _e5238 = select(_e2326, _e5236, (_e5236 < _e2326));
let _e5243 = global_5.member[bitcast<u32>(select(0i, _e5238, (_e5238 > 0i)))];
let _e5244 = (_e5227 + 3i);
let _e5246 = select(_e2326, _e5244, (_e5244 < _e2326));
let _e5251 = global_5.member[bitcast<u32>(select(0i, _e5246, (_e5246 > 0i)))];
let _e5254 = (_e5196 - bitcast<i32>((_e5235 & 65535u)));
let _e5259 = bitcast<i32>((_e5235 >> bitcast<u32>(16i)));
let _e5264 = (_e5211 - bitcast<i32>((_e5243 & 65535u)));
let _e5269 = bitcast<i32>((_e5243 >> bitcast<u32>(16i)));
let _e5274 = (_e5226 - bitcast<i32>((_e5251 & 65535u)));
if ((((_e5254 >= 0i) && ((_e5254 + 1i) < _e5259)) && ((_e5264 >= 0i) && ((_e5264 + 1i) < _e5269))) && ((_e5274 >= 0i) && ((_e5274 + 1i) < bitcast<i32>((_e5251 >> bitcast<u32>(16i)))))) {
let _e5284 = (_e5269 * _e5259);
let _e5286 = select(_e2326, _e5227, (_e5227 < _e2326));
let _e5291 = global_5.member[bitcast<u32>(select(0i, _e5286, (_e5286 > 0i)))];
let _e5297 = (((bitcast<i32>(_e5291) + (_e5274 * _e5284)) + (_e5264 * _e5259)) + _e5254);
let _e5299 = (_e5179 - f32(_e5196));
let _e5301 = (_e5180 - f32(_e5211));
let _e5304 = (2i * _e5297);
let _e5306 = (_e5304 >> bitcast<u32>(2i));
let _e5309 = bitcast<u32>(((_e5304 & 3i) * 8i));
let _e5311 = select(_e2326, _e5306, (_e5306 < _e2326));
let _e5316 = global_5.member[bitcast<u32>(select(0i, _e5311, (_e5311 > 0i)))];
let _e5320 = (_e5306 + 1i);
let _e5322 = select(_e2326, _e5320, (_e5320 < _e2326));
let _e5327 = global_5.member[bitcast<u32>(select(0i, _e5322, (_e5322 > 0i)))];
let _e5334 = ((_e5316 >> bitcast<u32>((_e5309 & 31u))) | ((_e5327 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e5309) & 31u))));
let _e5337 = f32(bitcast<i32>((_e5334 & 65535u)));
let _e5344 = (_e5337 + ((f32(bitcast<i32>((_e5334 >> bitcast<u32>(16i)))) - _e5337) * _e5299));
let _e5346 = (2i * (_e5297 + _e5259));
let _e5348 = (_e5346 >> bitcast<u32>(2i));
let _e5351 = bitcast<u32>(((_e5346 & 3i) * 8i));
let _e5353 = select(_e2326, _e5348, (_e5348 < _e2326));
let _e5358 = global_5.member[bitcast<u32>(select(0i, _e5353, (_e5353 > 0i)))];
let _e5362 = (_e5348 + 1i);
let _e5364 = select(_e2326, _e5362, (_e5362 < _e2326));
let _e5369 = global_5.member[bitcast<u32>(select(0i, _e5364, (_e5364 > 0i)))];
let _e5376 = ((_e5358 >> bitcast<u32>((_e5351 & 31u))) | ((_e5369 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e5351) & 31u))));
let _e5379 = f32(bitcast<i32>((_e5376 & 65535u)));
let _e5387 = (_e5297 + _e5284);
let _e5388 = (2i * _e5387);
let _e5390 = (_e5388 >> bitcast<u32>(2i));
let _e5393 = bitcast<u32>(((_e5388 & 3i) * 8i));
let _e5395 = select(_e2326, _e5390, (_e5390 < _e2326));
let _e5400 = global_5.member[bitcast<u32>(select(0i, _e5395, (_e5395 > 0i)))];
let _e5404 = (_e5390 + 1i);
let _e5406 = select(_e2326, _e5404, (_e5404 < _e2326));
let _e5411 = global_5.member[bitcast<u32>(select(0i, _e5406, (_e5406 > 0i)))];
let _e5418 = ((_e5400 >> bitcast<u32>((_e5393 & 31u))) | ((_e5411 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e5393) & 31u))));
let _e5421 = f32(bitcast<i32>((_e5418 & 65535u)));
let _e5428 = (_e5421 + ((f32(bitcast<i32>((_e5418 >> bitcast<u32>(16i)))) - _e5421) * _e5299));
let _e5430 = (2i * (_e5387 + _e5259));
let _e5432 = (_e5430 >> bitcast<u32>(2i));
let _e5435 = bitcast<u32>(((_e5430 & 3i) * 8i));
let _e5437 = select(_e2326, _e5432, (_e5432 < _e2326));
let _e5442 = global_5.member[bitcast<u32>(select(0i, _e5437, (_e5437 > 0i)))];
let _e5446 = (_e5432 + 1i);
let _e5448 = select(_e2326, _e5446, (_e5446 < _e2326));
let _e5453 = global_5.member[bitcast<u32>(select(0i, _e5448, (_e5448 > 0i)))];
let _e5460 = ((_e5442 >> bitcast<u32>((_e5435 & 31u))) | ((_e5453 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e5435) & 31u))));
let _e5463 = f32(bitcast<i32>((_e5460 & 65535u)));
let _e5473 = (_e5344 + (((_e5379 + ((f32(bitcast<i32>((_e5376 >> bitcast<u32>(16i)))) - _e5379) * _e5299)) - _e5344) * _e5301));
phi_7693_ = (_e5473 + (((_e5428 + (((_e5463 + ((f32(bitcast<i32>((_e5460 >> bitcast<u32>(16i)))) - _e5463) * _e5299)) - _e5428) * _e5301)) - _e5473) * (_e5181 - f32(_e5226))));
} else {
phi_7693_ = 0f;
}
let _e5481 = phi_7693_;
let _e5483 = local_2;
let _e5484 = local_3[0u];
let _e5486 = local_3[1u];
let _e5488 = local_3[2u];
let _e5490 = ((_e5484 + 0f) - 0.5f);
let _e5491 = ((_e5486 + 0f) - 0.5f);
let _e5492 = ((_e5488 + -1f) - 0.5f);
let _e5494 = select(0f, _e5490, (_e5490 > 0f));
let _e5496 = select(_e2273, _e5494, (_e5494 < _e2273));
let _e5503 = select(0i, select(select(i32(_e5496), i32(-2147483648), (_e5496 < -2147483600f)), 2147483647i, (_e5496 > 2147483500f)), (_e5496 == _e5496));
let _e5507 = (_e5503 - select(0i, 1i, (_e5496 < f32(_e5503))));
let _e5509 = select(0f, _e5491, (_e5491 > 0f));
let _e5511 = select(_e2290, _e5509, (_e5509 < _e2290));
let _e5518 = select(0i, select(select(i32(_e5511), i32(-2147483648), (_e5511 < -2147483600f)), 2147483647i, (_e5511 > 2147483500f)), (_e5511 == _e5511));
let _e5522 = (_e5518 - select(0i, 1i, (_e5511 < f32(_e5518))));
let _e5524 = select(0f, _e5492, (_e5492 > 0f));
let _e5526 = select(_e2307, _e5524, (_e5524 < _e2307));
let _e5533 = select(0i, select(select(i32(_e5526), i32(-2147483648), (_e5526 < -2147483600f)), 2147483647i, (_e5526 > 2147483500f)), (_e5526 == _e5526));
let _e5537 = (_e5533 - select(0i, 1i, (_e5526 < f32(_e5533))));
let _e5538 = (_e5483 * 4i);
let _e5539 = (_e5538 + 1i);
let _e5541 = select(_e2326, _e5539, (_e5539 < _e2326));
let _e5546 = global_5.member[bitcast<u32>(select(0i, _e5541, (_e5541 > 0i)))];
let _e5547 = (_e5538 + 2i);
let _e5549 = select(_e2326, _e5547, (_e5547 < _e2326));
let _e5554 = global_5.member[bitcast<u32>(select(0i, _e5549, (_e5549 > 0i)))];
let _e5555 = (_e5538 + 3i);
let _e5557 = select(_e2326, _e5555, (_e5555 < _e2326));
let _e5562 = global_5.member[bitcast<u32>(select(0i, _e5557, (_e5557 > 0i)))];
let _e5565 = (_e5507 - bitcast<i32>((_e5546 & 65535u)));
let _e5570 = bitcast<i32>((_e5546 >> bitcast<u32>(16i)));
let _e5575 = (_e5522 - bitcast<i32>((_e5554 & 65535u)));
let _e5580 = bitcast<i32>((_e5554 >> bitcast<u32>(16i)));
let _e5585 = (_e5537 - bitcast<i32>((_e5562 & 65535u)));
if ((((_e5565 >= 0i) && ((_e5565 + 1i) < _e5570)) && ((_e5575 >= 0i) && ((_e5575 + 1i) < _e5580))) && ((_e5585 >= 0i) && ((_e5585 + 1i) < bitcast<i32>((_e5562 >> bitcast<u32>(16i)))))) {
let _e5595 = (_e5580 * _e5570);
let _e5597 = select(_e2326, _e5538, (_e5538 < _e2326));
let _e5602 = global_5.member[bitcast<u32>(select(0i, _e5597, (_e5597 > 0i)))];
let _e5608 = (((bitcast<i32>(_e5602) + (_e5585 * _e5595)) + (_e5575 * _e5570)) + _e5565);
let _e5610 = (_e5490 - f32(_e5507));
let _e5612 = (_e5491 - f32(_e5522));
let _e5615 = (2i * _e5608);
let _e5617 = (_e5615 >> bitcast<u32>(2i));
let _e5620 = bitcast<u32>(((_e5615 & 3i) * 8i));
let _e5622 = select(_e2326, _e5617, (_e5617 < _e2326));
let _e5627 = global_5.member[bitcast<u32>(select(0i, _e5622, (_e5622 > 0i)))];
let _e5631 = (_e5617 + 1i);
let _e5633 = select(_e2326, _e5631, (_e5631 < _e2326));
let _e5638 = global_5.member[bitcast<u32>(select(0i, _e5633, (_e5633 > 0i)))];
let _e5645 = ((_e5627 >> bitcast<u32>((_e5620 & 31u))) | ((_e5638 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e5620) & 31u))));
let _e5648 = f32(bitcast<i32>((_e5645 & 65535u)));
let _e5655 = (_e5648 + ((f32(bitcast<i32>((_e5645 >> bitcast<u32>(16i)))) - _e5648) * _e5610));
let _e5657 = (2i * (_e5608 + _e5570));
let _e5659 = (_e5657 >> bitcast<u32>(2i));
let _e5662 = bitcast<u32>(((_e5657 & 3i) * 8i));
let _e5664 = select(_e2326, _e5659, (_e5659 < _e2326));
let _e5669 = global_5.member[bitcast<u32>(select(0i, _e5664, (_e5664 > 0i)))];
let _e5673 = (_e5659 + 1i);
let _e5675 = select(_e2326, _e5673, (_e5673 < _e2326));
let _e5680 = global_5.member[bitcast<u32>(select(0i, _e5675, (_e5675 > 0i)))];
let _e5687 = ((_e5669 >> bitcast<u32>((_e5662 & 31u))) | ((_e5680 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e5662) & 31u))));
let _e5690 = f32(bitcast<i32>((_e5687 & 65535u)));
let _e5698 = (_e5608 + _e5595);
let _e5699 = (2i * _e5698);
let _e5701 = (_e5699 >> bitcast<u32>(2i));
let _e5704 = bitcast<u32>(((_e5699 & 3i) * 8i));
let _e5706 = select(_e2326, _e5701, (_e5701 < _e2326));
let _e5711 = global_5.member[bitcast<u32>(select(0i, _e5706, (_e5706 > 0i)))];
let _e5715 = (_e5701 + 1i);
let _e5717 = select(_e2326, _e5715, (_e5715 < _e2326));
let _e5722 = global_5.member[bitcast<u32>(select(0i, _e5717, (_e5717 > 0i)))];
let _e5729 = ((_e5711 >> bitcast<u32>((_e5704 & 31u))) | ((_e5722 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e5704) & 31u))));
let _e5732 = f32(bitcast<i32>((_e5729 & 65535u)));
let _e5739 = (_e5732 + ((f32(bitcast<i32>((_e5729 >> bitcast<u32>(16i)))) - _e5732) * _e5610));
let _e5741 = (2i * (_e5698 + _e5570));
let _e5743 = (_e5741 >> bitcast<u32>(2i));
let _e5746 = bitcast<u32>(((_e5741 & 3i) * 8i));
let _e5748 = select(_e2326, _e5743, (_e5743 < _e2326));
let _e5753 = global_5.member[bitcast<u32>(select(0i, _e5748, (_e5748 > 0i)))];
let _e5757 = (_e5743 + 1i);
let _e5759 = select(_e2326, _e5757, (_e5757 < _e2326));
let _e5764 = global_5.member[bitcast<u32>(select(0i, _e5759, (_e5759 > 0i)))];
let _e5771 = ((_e5753 >> bitcast<u32>((_e5746 & 31u))) | ((_e5764 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e5746) & 31u))));
let _e5774 = f32(bitcast<i32>((_e5771 & 65535u)));
let _e5784 = (_e5655 + (((_e5690 + ((f32(bitcast<i32>((_e5687 >> bitcast<u32>(16i)))) - _e5690) * _e5610)) - _e5655) * _e5612));
phi_8133_ = (_e5784 + (((_e5739 + (((_e5774 + ((f32(bitcast<i32>((_e5771 >> bitcast<u32>(16i)))) - _e5774) * _e5610)) - _e5739) * _e5612)) - _e5784) * (_e5492 - f32(_e5537))));
} else {
phi_8133_ = 0f;
}
let _e5792 = phi_8133_;
let _e5793 = local_2;
let _e5794 = local_3[0u];
let _e5796 = local_3[1u];
let _e5798 = local_3[2u];
let _e5800 = ((_e5794 + 0f) - 0.5f);
let _e5801 = ((_e5796 + 0f) - 0.5f);
let _e5802 = ((_e5798 + 1f) - 0.5f);
let _e5804 = select(0f, _e5800, (_e5800 > 0f));
let _e5806 = select(_e2273, _e5804, (_e5804 < _e2273));
let _e5813 = select(0i, select(select(i32(_e5806), i32(-2147483648), (_e5806 < -2147483600f)), 2147483647i, (_e5806 > 2147483500f)), (_e5806 == _e5806));
let _e5817 = (_e5813 - select(0i, 1i, (_e5806 < f32(_e5813))));
let _e5819 = select(0f, _e5801, (_e5801 > 0f));
let _e5821 = select(_e2290, _e5819, (_e5819 < _e2290));
let _e5828 = select(0i, select(select(i32(_e5821), i32(-2147483648), (_e5821 < -2147483600f)), 2147483647i, (_e5821 > 2147483500f)), (_e5821 == _e5821));
let _e5832 = (_e5828 - select(0i, 1i, (_e5821 < f32(_e5828))));
let _e5834 = select(0f, _e5802, (_e5802 > 0f));
let _e5836 = select(_e2307, _e5834, (_e5834 < _e2307));
let _e5843 = select(0i, select(select(i32(_e5836), i32(-2147483648), (_e5836 < -2147483600f)), 2147483647i, (_e5836 > 2147483500f)), (_e5836 == _e5836));
let _e5847 = (_e5843 - select(0i, 1i, (_e5836 < f32(_e5843))));
let _e5848 = (_e5793 * 4i);
let _e5849 = (_e5848 + 1i);
let _e5851 = select(_e2326, _e5849, (_e5849 < _e2326));
let _e5856 = global_5.member[bitcast<u32>(select(0i, _e5851, (_e5851 > 0i)))];
let _e5857 = (_e5848 + 2i);
let _e5859 = select(_e2326, _e5857, (_e5857 < _e2326));
let _e5864 = global_5.member[bitcast<u32>(select(0i, _e5859, (_e5859 > 0i)))];
let _e5865 = (_e5848 + 3i);
let _e5867 = select(_e2326, _e5865, (_e5865 < _e2326));
let _e5872 = global_5.member[bitcast<u32>(select(0i, _e5867, (_e5867 > 0i)))];
let _e5875 = (_e5817 - bitcast<i32>((_e5856 & 65535u)));
let _e5880 = bitcast<i32>((_e5856 >> bitcast<u32>(16i)));
let _e5885 = (_e5832 - bitcast<i32>((_e5864 & 65535u)));
let _e5890 = bitcast<i32>((_e5864 >> bitcast<u32>(16i)));
let _e5895 = (_e5847 - bitcast<i32>((_e5872 & 65535u)));
if ((((_e5875 >= 0i) && ((_e5875 + 1i) < _e5880)) && ((_e5885 >= 0i) && ((_e5885 + 1i) < _e5890))) && ((_e5895 >= 0i) && ((_e5895 + 1i) < bitcast<i32>((_e5872 >> bitcast<u32>(16i)))))) {
let _e5905 = (_e5890 * _e5880);
let _e5907 = select(_e2326, _e5848, (_e5848 < _e2326));
let _e5912 = global_5.member[bitcast<u32>(select(0i, _e5907, (_e5907 > 0i)))];
let _e5918 = (((bitcast<i32>(_e5912) + (_e5895 * _e5905)) + (_e5885 * _e5880)) + _e5875);
let _e5920 = (_e5800 - f32(_e5817));
let _e5922 = (_e5801 - f32(_e5832));
let _e5925 = (2i * _e5918);
let _e5927 = (_e5925 >> bitcast<u32>(2i));
let _e5930 = bitcast<u32>(((_e5925 & 3i) * 8i));
let _e5932 = select(_e2326, _e5927, (_e5927 < _e2326));
let _e5937 = global_5.member[bitcast<u32>(select(0i, _e5932, (_e5932 > 0i)))];
let _e5941 = (_e5927 + 1i);
let _e5943 = select(_e2326, _e5941, (_e5941 < _e2326));
let _e5948 = global_5.member[bitcast<u32>(select(0i, _e5943, (_e5943 > 0i)))];
let _e5955 = ((_e5937 >> bitcast<u32>((_e5930 & 31u))) | ((_e5948 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e5930) & 31u))));
let _e5958 = f32(bitcast<i32>((_e5955 & 65535u)));
let _e5965 = (_e5958 + ((f32(bitcast<i32>((_e5955 >> bitcast<u32>(16i)))) - _e5958) * _e5920));
let _e5967 = (2i * (_e5918 + _e5880));
let _e5969 = (_e5967 >> bitcast<u32>(2i));
let _e5972 = bitcast<u32>(((_e5967 & 3i) * 8i));
let _e5974 = select(_e2326, _e5969, (_e5969 < _e2326));
let _e5979 = global_5.member[bitcast<u32>(select(0i, _e5974, (_e5974 > 0i)))];
let _e5983 = (_e5969 + 1i);
let _e5985 = select(_e2326, _e5983, (_e5983 < _e2326));
let _e5990 = global_5.member[bitcast<u32>(select(0i, _e5985, (_e5985 > 0i)))];
let _e5997 = ((_e5979 >> bitcast<u32>((_e5972 & 31u))) | ((_e5990 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e5972) & 31u))));
let _e6000 = f32(bitcast<i32>((_e5997 & 65535u)));
let _e6008 = (_e5918 + _e5905);
let _e6009 = (2i * _e6008);
let _e6011 = (_e6009 >> bitcast<u32>(2i));
let _e6014 = bitcast<u32>(((_e6009 & 3i) * 8i));
let _e6016 = select(_e2326, _e6011, (_e6011 < _e2326));
let _e6021 = global_5.member[bitcast<u32>(select(0i, _e6016, (_e6016 > 0i)))];
let _e6025 = (_e6011 + 1i);
let _e6027 = select(_e2326, _e6025, (_e6025 < _e2326));
let _e6032 = global_5.member[bitcast<u32>(select(0i, _e6027, (_e6027 > 0i)))];
let _e6039 = ((_e6021 >> bitcast<u32>((_e6014 & 31u))) | ((_e6032 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e6014) & 31u))));
let _e6042 = f32(bitcast<i32>((_e6039 & 65535u)));
let _e6049 = (_e6042 + ((f32(bitcast<i32>((_e6039 >> bitcast<u32>(16i)))) - _e6042) * _e5920));
let _e6051 = (2i * (_e6008 + _e5880));
let _e6053 = (_e6051 >> bitcast<u32>(2i));
let _e6056 = bitcast<u32>(((_e6051 & 3i) * 8i));
let _e6058 = select(_e2326, _e6053, (_e6053 < _e2326));
let _e6063 = global_5.member[bitcast<u32>(select(0i, _e6058, (_e6058 > 0i)))];
let _e6067 = (_e6053 + 1i);
let _e6069 = select(_e2326, _e6067, (_e6067 < _e2326));
let _e6074 = global_5.member[bitcast<u32>(select(0i, _e6069, (_e6069 > 0i)))];
let _e6081 = ((_e6063 >> bitcast<u32>((_e6056 & 31u))) | ((_e6074 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e6056) & 31u))));
let _e6084 = f32(bitcast<i32>((_e6081 & 65535u)));
let _e6094 = (_e5965 + (((_e6000 + ((f32(bitcast<i32>((_e5997 >> bitcast<u32>(16i)))) - _e6000) * _e5920)) - _e5965) * _e5922));
phi_8572_ = (_e6094 + (((_e6049 + (((_e6084 + ((f32(bitcast<i32>((_e6081 >> bitcast<u32>(16i)))) - _e6084) * _e5920)) - _e6049) * _e5922)) - _e6094) * (_e5802 - f32(_e5847))));
} else {
phi_8572_ = 0f;
}
let _e6102 = phi_8572_;
let _e6104 = ((_e4550 - _e4860) * _e4133);
let _e6105 = ((_e5171 - _e5481) * _e4133);
let _e6106 = ((_e5792 - _e6102) * _e4133);
let _e6110 = global_1.member.member_2.member;
let _e6115 = global_1.member.member_2.member_1;
let _e6120 = global_1.member.member_2.member_2;
let _e6122 = (_e4234 - 0.5f);
let _e6123 = (_e4235 - 0.5f);
let _e6124 = (_e4236 - 0.5f);
let _e6126 = f32((bitcast<i32>(_e6110) - 2i));
let _e6128 = select(0f, _e6122, (_e6122 > 0f));
let _e6130 = select(_e6126, _e6128, (_e6128 < _e6126));
let _e6137 = select(0i, select(select(i32(_e6130), i32(-2147483648), (_e6130 < -2147483600f)), 2147483647i, (_e6130 > 2147483500f)), (_e6130 == _e6130));
let _e6141 = (_e6137 - select(0i, 1i, (_e6130 < f32(_e6137))));
let _e6143 = f32((bitcast<i32>(_e6115) - 2i));
let _e6145 = select(0f, _e6123, (_e6123 > 0f));
let _e6147 = select(_e6143, _e6145, (_e6145 < _e6143));
let _e6154 = select(0i, select(select(i32(_e6147), i32(-2147483648), (_e6147 < -2147483600f)), 2147483647i, (_e6147 > 2147483500f)), (_e6147 == _e6147));
let _e6158 = (_e6154 - select(0i, 1i, (_e6147 < f32(_e6154))));
let _e6160 = f32((bitcast<i32>(_e6120) - 2i));
let _e6162 = select(0f, _e6124, (_e6124 > 0f));
let _e6164 = select(_e6160, _e6162, (_e6162 < _e6160));
let _e6171 = select(0i, select(select(i32(_e6164), i32(-2147483648), (_e6164 < -2147483600f)), 2147483647i, (_e6164 > 2147483500f)), (_e6164 == _e6164));
let _e6175 = (_e6171 - select(0i, 1i, (_e6164 < f32(_e6171))));
let _e6176 = (_e2246 * 4i);
let _e6177 = (_e6176 + 1i);
let _e6179 = select(_e2326, _e6177, (_e6177 < _e2326));
let _e6185 = global_5.member[bitcast<u32>(select(0i, _e6179, (_e6179 > 0i)))];
let _e6186 = (_e6176 + 2i);
let _e6188 = select(_e2326, _e6186, (_e6186 < _e2326));
let _e6194 = global_5.member[bitcast<u32>(select(0i, _e6188, (_e6188 > 0i)))];
let _e6195 = (_e6176 + 3i);
let _e6197 = select(_e2326, _e6195, (_e6195 < _e2326));
let _e6203 = global_5.member[bitcast<u32>(select(0i, _e6197, (_e6197 > 0i)))];
let _e6205 = bitcast<i32>((_e6185 & 65535u));
let _e6206 = (_e6141 - _e6205);
let _e6211 = bitcast<i32>((_e6185 >> bitcast<u32>(16i)));
let _e6215 = bitcast<i32>((_e6194 & 65535u));
let _e6216 = (_e6158 - _e6215);
let _e6221 = bitcast<i32>((_e6194 >> bitcast<u32>(16i)));
let _e6225 = bitcast<i32>((_e6203 & 65535u));
let _e6226 = (_e6175 - _e6225);
let _e6231 = bitcast<i32>((_e6203 >> bitcast<u32>(16i)));
if ((((_e6206 >= 0i) && ((_e6206 + 1i) < _e6211)) && ((_e6216 >= 0i) && ((_e6216 + 1i) < _e6221))) && ((_e6226 >= 0i) && ((_e6226 + 1i) < _e6231))) {
let _e6236 = (_e6221 * _e6211);
let _e6238 = select(_e2326, _e6176, (_e6176 < _e2326));
let _e6244 = global_5.member[bitcast<u32>(select(0i, _e6238, (_e6238 > 0i)))];
let _e6250 = (((bitcast<i32>(_e6244) + (_e6226 * _e6236)) + (_e6216 * _e6211)) + _e6206);
let _e6252 = (_e6122 - f32(_e6141));
let _e6254 = (_e6123 - f32(_e6158));
let _e6257 = (2i * _e6250);
let _e6259 = (_e6257 >> bitcast<u32>(2i));
let _e6262 = bitcast<u32>(((_e6257 & 3i) * 8i));
let _e6264 = select(_e2326, _e6259, (_e6259 < _e2326));
let _e6270 = global_5.member[bitcast<u32>(select(0i, _e6264, (_e6264 > 0i)))];
let _e6274 = (_e6259 + 1i);
let _e6276 = select(_e2326, _e6274, (_e6274 < _e2326));
let _e6282 = global_5.member[bitcast<u32>(select(0i, _e6276, (_e6276 > 0i)))];
let _e6289 = ((_e6270 >> bitcast<u32>((_e6262 & 31u))) | ((_e6282 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e6262) & 31u))));
let _e6292 = f32(bitcast<i32>((_e6289 & 65535u)));
let _e6299 = (_e6292 + ((f32(bitcast<i32>((_e6289 >> bitcast<u32>(16i)))) - _e6292) * _e6252));
let _e6301 = (2i * (_e6250 + _e6211));
let _e6303 = (_e6301 >> bitcast<u32>(2i));
let _e6306 = bitcast<u32>(((_e6301 & 3i) * 8i));
let _e6308 = select(_e2326, _e6303, (_e6303 < _e2326));
let _e6314 = global_5.member[bitcast<u32>(select(0i, _e6308, (_e6308 > 0i)))];
let _e6318 = (_e6303 + 1i);
let _e6320 = select(_e2326, _e6318, (_e6318 < _e2326));
let _e6326 = global_5.member[bitcast<u32>(select(0i, _e6320, (_e6320 > 0i)))];
let _e6333 = ((_e6314 >> bitcast<u32>((_e6306 & 31u))) | ((_e6326 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e6306) & 31u))));
let _e6336 = f32(bitcast<i32>((_e6333 & 65535u)));
let _e6344 = (_e6250 + _e6236);
let _e6345 = (2i * _e6344);
let _e6347 = (_e6345 >> bitcast<u32>(2i));
let _e6350 = bitcast<u32>(((_e6345 & 3i) * 8i));
let _e6352 = select(_e2326, _e6347, (_e6347 < _e2326));
let _e6358 = global_5.member[bitcast<u32>(select(0i, _e6352, (_e6352 > 0i)))];
let _e6362 = (_e6347 + 1i);
let _e6364 = select(_e2326, _e6362, (_e6362 < _e2326));
let _e6370 = global_5.member[bitcast<u32>(select(0i, _e6364, (_e6364 > 0i)))];
let _e6377 = ((_e6358 >> bitcast<u32>((_e6350 & 31u))) | ((_e6370 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e6350) & 31u))));
let _e6380 = f32(bitcast<i32>((_e6377 & 65535u)));
let _e6387 = (_e6380 + ((f32(bitcast<i32>((_e6377 >> bitcast<u32>(16i)))) - _e6380) * _e6252));
let _e6389 = (2i * (_e6344 + _e6211));
let _e6391 = (_e6389 >> bitcast<u32>(2i));
let _e6394 = bitcast<u32>(((_e6389 & 3i) * 8i));
let _e6396 = select(_e2326, _e6391, (_e6391 < _e2326));
let _e6402 = global_5.member[bitcast<u32>(select(0i, _e6396, (_e6396 > 0i)))];
let _e6406 = (_e6391 + 1i);
let _e6408 = select(_e2326, _e6406, (_e6406 < _e2326));
let _e6414 = global_5.member[bitcast<u32>(select(0i, _e6408, (_e6408 > 0i)))];
let _e6421 = ((_e6402 >> bitcast<u32>((_e6394 & 31u))) | ((_e6414 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e6394) & 31u))));
let _e6424 = f32(bitcast<i32>((_e6421 & 65535u)));
let _e6434 = (_e6299 + (((_e6336 + ((f32(bitcast<i32>((_e6333 >> bitcast<u32>(16i)))) - _e6336) * _e6252)) - _e6299) * _e6254));
phi_9006_ = (_e6434 + (((_e6387 + (((_e6424 + ((f32(bitcast<i32>((_e6421 >> bitcast<u32>(16i)))) - _e6424) * _e6252)) - _e6387) * _e6254)) - _e6434) * (_e6124 - f32(_e6175))));
} else {
phi_9006_ = 0f;
}
let _e6442 = phi_9006_;
let _e6444 = (1f / 5461.25f);
let _e6450 = (((_e6104 * _e6104) + (_e6105 * _e6105)) + (_e6106 * _e6106));
let _e6453 = (((32767.5f - _e6442) * _e6444) / select(0.25f, _e6450, (_e6450 > 0.25f)));
let _e6457 = (_e4234 - (_e6104 * _e6453));
let _e6458 = (_e4235 - (_e6105 * _e6453));
let _e6459 = (_e4236 - (_e6106 * _e6453));
local = _e2246;
local_1 = vec3<f32>(_e6457, _e6458, _e6459);
let _e6464 = local;
let _e6465 = local_1[0u];
let _e6467 = local_1[1u];
let _e6469 = local_1[2u];
let _e6471 = ((_e6465 + -1f) - 0.5f);
let _e6472 = ((_e6467 + 0f) - 0.5f);
let _e6473 = ((_e6469 + 0f) - 0.5f);
let _e6475 = select(0f, _e6471, (_e6471 > 0f));
let _e6477 = select(_e2273, _e6475, (_e6475 < _e2273));
let _e6484 = select(0i, select(select(i32(_e6477), i32(-2147483648), (_e6477 < -2147483600f)), 2147483647i, (_e6477 > 2147483500f)), (_e6477 == _e6477));
let _e6488 = (_e6484 - select(0i, 1i, (_e6477 < f32(_e6484))));
let _e6490 = select(0f, _e6472, (_e6472 > 0f));
let _e6492 = select(_e2290, _e6490, (_e6490 < _e2290));
let _e6499 = select(0i, select(select(i32(_e6492), i32(-2147483648), (_e6492 < -2147483600f)), 2147483647i, (_e6492 > 2147483500f)), (_e6492 == _e6492));
let _e6503 = (_e6499 - select(0i, 1i, (_e6492 < f32(_e6499))));
let _e6505 = select(0f, _e6473, (_e6473 > 0f));
let _e6507 = select(_e2307, _e6505, (_e6505 < _e2307));
let _e6514 = select(0i, select(select(i32(_e6507), i32(-2147483648), (_e6507 < -2147483600f)), 2147483647i, (_e6507 > 2147483500f)), (_e6507 == _e6507));
let _e6518 = (_e6514 - select(0i, 1i, (_e6507 < f32(_e6514))));
let _e6519 = (_e6464 * 4i);
let _e6520 = (_e6519 + 1i);
let _e6522 = select(_e2326, _e6520, (_e6520 < _e2326));
let _e6527 = global_5.member[bitcast<u32>(select(0i, _e6522, (_e6522 > 0i)))];
let _e6528 = (_e6519 + 2i);
let _e6530 = select(_e2326, _e6528, (_e6528 < _e2326));
let _e6535 = global_5.member[bitcast<u32>(select(0i, _e6530, (_e6530 > 0i)))];
let _e6536 = (_e6519 + 3i);
let _e6538 = select(_e2326, _e6536, (_e6536 < _e2326));
let _e6543 = global_5.member[bitcast<u32>(select(0i, _e6538, (_e6538 > 0i)))];
let _e6546 = (_e6488 - bitcast<i32>((_e6527 & 65535u)));
let _e6551 = bitcast<i32>((_e6527 >> bitcast<u32>(16i)));
let _e6556 = (_e6503 - bitcast<i32>((_e6535 & 65535u)));
let _e6561 = bitcast<i32>((_e6535 >> bitcast<u32>(16i)));
let _e6566 = (_e6518 - bitcast<i32>((_e6543 & 65535u)));
if ((((_e6546 >= 0i) && ((_e6546 + 1i) < _e6551)) && ((_e6556 >= 0i) && ((_e6556 + 1i) < _e6561))) && ((_e6566 >= 0i) && ((_e6566 + 1i) < bitcast<i32>((_e6543 >> bitcast<u32>(16i)))))) {
let _e6576 = (_e6561 * _e6551);
let _e6578 = select(_e2326, _e6519, (_e6519 < _e2326));
let _e6583 = global_5.member[bitcast<u32>(select(0i, _e6578, (_e6578 > 0i)))];
let _e6589 = (((bitcast<i32>(_e6583) + (_e6566 * _e6576)) + (_e6556 * _e6551)) + _e6546);
let _e6591 = (_e6471 - f32(_e6488));
let _e6593 = (_e6472 - f32(_e6503));
let _e6596 = (2i * _e6589);
let _e6598 = (_e6596 >> bitcast<u32>(2i));
let _e6601 = bitcast<u32>(((_e6596 & 3i) * 8i));
let _e6603 = select(_e2326, _e6598, (_e6598 < _e2326));
let _e6608 = global_5.member[bitcast<u32>(select(0i, _e6603, (_e6603 > 0i)))];
let _e6612 = (_e6598 + 1i);
let _e6614 = select(_e2326, _e6612, (_e6612 < _e2326));
let _e6619 = global_5.member[bitcast<u32>(select(0i, _e6614, (_e6614 > 0i)))];
let _e6626 = ((_e6608 >> bitcast<u32>((_e6601 & 31u))) | ((_e6619 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e6601) & 31u))));
let _e6629 = f32(bitcast<i32>((_e6626 & 65535u)));
let _e6636 = (_e6629 + ((f32(bitcast<i32>((_e6626 >> bitcast<u32>(16i)))) - _e6629) * _e6591));
let _e6638 = (2i * (_e6589 + _e6551));
let _e6640 = (_e6638 >> bitcast<u32>(2i));
let _e6643 = bitcast<u32>(((_e6638 & 3i) * 8i));
let _e6645 = select(_e2326, _e6640, (_e6640 < _e2326));
let _e6650 = global_5.member[bitcast<u32>(select(0i, _e6645, (_e6645 > 0i)))];
let _e6654 = (_e6640 + 1i);
let _e6656 = select(_e2326, _e6654, (_e6654 < _e2326));
let _e6661 = global_5.member[bitcast<u32>(select(0i, _e6656, (_e6656 > 0i)))];
let _e6668 = ((_e6650 >> bitcast<u32>((_e6643 & 31u))) | ((_e6661 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e6643) & 31u))));
let _e6671 = f32(bitcast<i32>((_e6668 & 65535u)));
let _e6679 = (_e6589 + _e6576);
let _e6680 = (2i * _e6679);
let _e6682 = (_e6680 >> bitcast<u32>(2i));
let _e6685 = bitcast<u32>(((_e6680 & 3i) * 8i));
let _e6687 = select(_e2326, _e6682, (_e6682 < _e2326));
let _e6692 = global_5.member[bitcast<u32>(select(0i, _e6687, (_e6687 > 0i)))];
let _e6696 = (_e6682 + 1i);
let _e6698 = select(_e2326, _e6696, (_e6696 < _e2326));
let _e6703 = global_5.member[bitcast<u32>(select(0i, _e6698, (_e6698 > 0i)))];
let _e6710 = ((_e6692 >> bitcast<u32>((_e6685 & 31u))) | ((_e6703 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e6685) & 31u))));
let _e6713 = f32(bitcast<i32>((_e6710 & 65535u)));
let _e6720 = (_e6713 + ((f32(bitcast<i32>((_e6710 >> bitcast<u32>(16i)))) - _e6713) * _e6591));
let _e6722 = (2i * (_e6679 + _e6551));
let _e6724 = (_e6722 >> bitcast<u32>(2i));
let _e6727 = bitcast<u32>(((_e6722 & 3i) * 8i));
let _e6729 = select(_e2326, _e6724, (_e6724 < _e2326));
let _e6734 = global_5.member[bitcast<u32>(select(0i, _e6729, (_e6729 > 0i)))];
let _e6738 = (_e6724 + 1i);
let _e6740 = select(_e2326, _e6738, (_e6738 < _e2326));
let _e6745 = global_5.member[bitcast<u32>(select(0i, _e6740, (_e6740 > 0i)))];
let _e6752 = ((_e6734 >> bitcast<u32>((_e6727 & 31u))) | ((_e6745 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e6727) & 31u))));
let _e6755 = f32(bitcast<i32>((_e6752 & 65535u)));
let _e6765 = (_e6636 + (((_e6671 + ((f32(bitcast<i32>((_e6668 >> bitcast<u32>(16i)))) - _e6671) * _e6591)) - _e6636) * _e6593));
phi_9476_ = (_e6765 + (((_e6720 + (((_e6755 + ((f32(bitcast<i32>((_e6752 >> bitcast<u32>(16i)))) - _e6755) * _e6591)) - _e6720) * _e6593)) - _e6765) * (_e6473 - f32(_e6518))));
} else {
phi_9476_ = 0f;
}
let _e6773 = phi_9476_;
let _e6774 = local;
let _e6775 = local_1[0u];
let _e6777 = local_1[1u];
let _e6779 = local_1[2u];
let _e6781 = ((_e6775 + 1f) - 0.5f);
let _e6782 = ((_e6777 + 0f) - 0.5f);
let _e6783 = ((_e6779 + 0f) - 0.5f);
let _e6785 = select(0f, _e6781, (_e6781 > 0f));
let _e6787 = select(_e2273, _e6785, (_e6785 < _e2273));
let _e6794 = select(0i, select(select(i32(_e6787), i32(-2147483648), (_e6787 < -2147483600f)), 2147483647i, (_e6787 > 2147483500f)), (_e6787 == _e6787));
let _e6798 = (_e6794 - select(0i, 1i, (_e6787 < f32(_e6794))));
let _e6800 = select(0f, _e6782, (_e6782 > 0f));
let _e6802 = select(_e2290, _e6800, (_e6800 < _e2290));
let _e6809 = select(0i, select(select(i32(_e6802), i32(-2147483648), (_e6802 < -2147483600f)), 2147483647i, (_e6802 > 2147483500f)), (_e6802 == _e6802));
let _e6813 = (_e6809 - select(0i, 1i, (_e6802 < f32(_e6809))));
let _e6815 = select(0f, _e6783, (_e6783 > 0f));
let _e6817 = select(_e2307, _e6815, (_e6815 < _e2307));
let _e6824 = select(0i, select(select(i32(_e6817), i32(-2147483648), (_e6817 < -2147483600f)), 2147483647i, (_e6817 > 2147483500f)), (_e6817 == _e6817));
let _e6828 = (_e6824 - select(0i, 1i, (_e6817 < f32(_e6824))));
let _e6829 = (_e6774 * 4i);
let _e6830 = (_e6829 + 1i);
let _e6832 = select(_e2326, _e6830, (_e6830 < _e2326));
let _e6837 = global_5.member[bitcast<u32>(select(0i, _e6832, (_e6832 > 0i)))];
let _e6838 = (_e6829 + 2i);
let _e6840 = select(_e2326, _e6838, (_e6838 < _e2326));
let _e6845 = global_5.member[bitcast<u32>(select(0i, _e6840, (_e6840 > 0i)))];
let _e6846 = (_e6829 + 3i);
let _e6848 = select(_e2326, _e6846, (_e6846 < _e2326));
let _e6853 = global_5.member[bitcast<u32>(select(0i, _e6848, (_e6848 > 0i)))];
let _e6856 = (_e6798 - bitcast<i32>((_e6837 & 65535u)));
let _e6861 = bitcast<i32>((_e6837 >> bitcast<u32>(16i)));
let _e6866 = (_e6813 - bitcast<i32>((_e6845 & 65535u)));
let _e6871 = bitcast<i32>((_e6845 >> bitcast<u32>(16i)));
let _e6876 = (_e6828 - bitcast<i32>((_e6853 & 65535u)));
if ((((_e6856 >= 0i) && ((_e6856 + 1i) < _e6861)) && ((_e6866 >= 0i) && ((_e6866 + 1i) < _e6871))) && ((_e6876 >= 0i) && ((_e6876 + 1i) < bitcast<i32>((_e6853 >> bitcast<u32>(16i)))))) {
let _e6886 = (_e6871 * _e6861);
let _e6888 = select(_e2326, _e6829, (_e6829 < _e2326));
let _e6893 = global_5.member[bitcast<u32>(select(0i, _e6888, (_e6888 > 0i)))];
let _e6899 = (((bitcast<i32>(_e6893) + (_e6876 * _e6886)) + (_e6866 * _e6861)) + _e6856);
let _e6901 = (_e6781 - f32(_e6798));
let _e6903 = (_e6782 - f32(_e6813));
let _e6906 = (2i * _e6899);
let _e6908 = (_e6906 >> bitcast<u32>(2i));
let _e6911 = bitcast<u32>(((_e6906 & 3i) * 8i));
let _e6913 = select(_e2326, _e6908, (_e6908 < _e2326));
let _e6918 = global_5.member[bitcast<u32>(select(0i, _e6913, (_e6913 > 0i)))];
let _e6922 = (_e6908 + 1i);
let _e6924 = select(_e2326, _e6922, (_e6922 < _e2326));
let _e6929 = global_5.member[bitcast<u32>(select(0i, _e6924, (_e6924 > 0i)))];
let _e6936 = ((_e6918 >> bitcast<u32>((_e6911 & 31u))) | ((_e6929 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e6911) & 31u))));
let _e6939 = f32(bitcast<i32>((_e6936 & 65535u)));
let _e6946 = (_e6939 + ((f32(bitcast<i32>((_e6936 >> bitcast<u32>(16i)))) - _e6939) * _e6901));
let _e6948 = (2i * (_e6899 + _e6861));
let _e6950 = (_e6948 >> bitcast<u32>(2i));
let _e6953 = bitcast<u32>(((_e6948 & 3i) * 8i));
let _e6955 = select(_e2326, _e6950, (_e6950 < _e2326));
let _e6960 = global_5.member[bitcast<u32>(select(0i, _e6955, (_e6955 > 0i)))];
let _e6964 = (_e6950 + 1i);
let _e6966 = select(_e2326, _e6964, (_e6964 < _e2326));
let _e6971 = global_5.member[bitcast<u32>(select(0i, _e6966, (_e6966 > 0i)))];
let _e6978 = ((_e6960 >> bitcast<u32>((_e6953 & 31u))) | ((_e6971 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e6953) & 31u))));
let _e6981 = f32(bitcast<i32>((_e6978 & 65535u)));
let _e6989 = (_e6899 + _e6886);
let _e6990 = (2i * _e6989);
let _e6992 = (_e6990 >> bitcast<u32>(2i));
let _e6995 = bitcast<u32>(((_e6990 & 3i) * 8i));
let _e6997 = select(_e2326, _e6992, (_e6992 < _e2326));
let _e7002 = global_5.member[bitcast<u32>(select(0i, _e6997, (_e6997 > 0i)))];
let _e7006 = (_e6992 + 1i);
let _e7008 = select(_e2326, _e7006, (_e7006 < _e2326));
let _e7013 = global_5.member[bitcast<u32>(select(0i, _e7008, (_e7008 > 0i)))];
let _e7020 = ((_e7002 >> bitcast<u32>((_e6995 & 31u))) | ((_e7013 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e6995) & 31u))));
let _e7023 = f32(bitcast<i32>((_e7020 & 65535u)));
let _e7030 = (_e7023 + ((f32(bitcast<i32>((_e7020 >> bitcast<u32>(16i)))) - _e7023) * _e6901));
let _e7032 = (2i * (_e6989 + _e6861));
let _e7034 = (_e7032 >> bitcast<u32>(2i));
let _e7037 = bitcast<u32>(((_e7032 & 3i) * 8i));
let _e7039 = select(_e2326, _e7034, (_e7034 < _e2326));
let _e7044 = global_5.member[bitcast<u32>(select(0i, _e7039, (_e7039 > 0i)))];
let _e7048 = (_e7034 + 1i);
let _e7050 = select(_e2326, _e7048, (_e7048 < _e2326));
let _e7055 = global_5.member[bitcast<u32>(select(0i, _e7050, (_e7050 > 0i)))];
let _e7062 = ((_e7044 >> bitcast<u32>((_e7037 & 31u))) | ((_e7055 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e7037) & 31u))));
let _e7065 = f32(bitcast<i32>((_e7062 & 65535u)));
let _e7075 = (_e6946 + (((_e6981 + ((f32(bitcast<i32>((_e6978 >> bitcast<u32>(16i)))) - _e6981) * _e6901)) - _e6946) * _e6903));
phi_9915_ = (_e7075 + (((_e7030 + (((_e7065 + ((f32(bitcast<i32>((_e7062 >> bitcast<u32>(16i)))) - _e7065) * _e6901)) - _e7030) * _e6903)) - _e7075) * (_e6783 - f32(_e6828))));
} else {
phi_9915_ = 0f;
}
let _e7083 = phi_9915_;
let _e7085 = local;
let _e7086 = local_1[0u];
let _e7088 = local_1[1u];
let _e7090 = local_1[2u];
let _e7092 = ((_e7086 + 0f) - 0.5f);
let _e7093 = ((_e7088 + -1f) - 0.5f);
let _e7094 = ((_e7090 + 0f) - 0.5f);
let _e7096 = select(0f, _e7092, (_e7092 > 0f));
let _e7098 = select(_e2273, _e7096, (_e7096 < _e2273));
let _e7105 = select(0i, select(select(i32(_e7098), i32(-2147483648), (_e7098 < -2147483600f)), 2147483647i, (_e7098 > 2147483500f)), (_e7098 == _e7098));
let _e7109 = (_e7105 - select(0i, 1i, (_e7098 < f32(_e7105))));
let _e7111 = select(0f, _e7093, (_e7093 > 0f));
let _e7113 = select(_e2290, _e7111, (_e7111 < _e2290));
let _e7120 = select(0i, select(select(i32(_e7113), i32(-2147483648), (_e7113 < -2147483600f)), 2147483647i, (_e7113 > 2147483500f)), (_e7113 == _e7113));
let _e7124 = (_e7120 - select(0i, 1i, (_e7113 < f32(_e7120))));
let _e7126 = select(0f, _e7094, (_e7094 > 0f));
let _e7128 = select(_e2307, _e7126, (_e7126 < _e2307));
let _e7135 = select(0i, select(select(i32(_e7128), i32(-2147483648), (_e7128 < -2147483600f)), 2147483647i, (_e7128 > 2147483500f)), (_e7128 == _e7128));
let _e7139 = (_e7135 - select(0i, 1i, (_e7128 < f32(_e7135))));
let _e7140 = (_e7085 * 4i);
let _e7141 = (_e7140 + 1i);
let _e7143 = select(_e2326, _e7141, (_e7141 < _e2326));
let _e7148 = global_5.member[bitcast<u32>(select(0i, _e7143, (_e7143 > 0i)))];
let _e7149 = (_e7140 + 2i);
let _e7151 = select(_e2326, _e7149, (_e7149 < _e2326));
let _e7156 = global_5.member[bitcast<u32>(select(0i, _e7151, (_e7151 > 0i)))];
let _e7157 = (_e7140 + 3i);
let _e7159 = select(_e2326, _e7157, (_e7157 < _e2326));
let _e7164 = global_5.member[bitcast<u32>(select(0i, _e7159, (_e7159 > 0i)))];
let _e7167 = (_e7109 - bitcast<i32>((_e7148 & 65535u)));
let _e7172 = bitcast<i32>((_e7148 >> bitcast<u32>(16i)));
let _e7177 = (_e7124 - bitcast<i32>((_e7156 & 65535u)));
let _e7182 = bitcast<i32>((_e7156 >> bitcast<u32>(16i)));
let _e7187 = (_e7139 - bitcast<i32>((_e7164 & 65535u)));
if ((((_e7167 >= 0i) && ((_e7167 + 1i) < _e7172)) && ((_e7177 >= 0i) && ((_e7177 + 1i) < _e7182))) && ((_e7187 >= 0i) && ((_e7187 + 1i) < bitcast<i32>((_e7164 >> bitcast<u32>(16i)))))) {
let _e7197 = (_e7182 * _e7172);
let _e7199 = select(_e2326, _e7140, (_e7140 < _e2326));
let _e7204 = global_5.member[bitcast<u32>(select(0i, _e7199, (_e7199 > 0i)))];
let _e7210 = (((bitcast<i32>(_e7204) + (_e7187 * _e7197)) + (_e7177 * _e7172)) + _e7167);
let _e7212 = (_e7092 - f32(_e7109));
let _e7214 = (_e7093 - f32(_e7124));
let _e7217 = (2i * _e7210);
let _e7219 = (_e7217 >> bitcast<u32>(2i));
let _e7222 = bitcast<u32>(((_e7217 & 3i) * 8i));
let _e7224 = select(_e2326, _e7219, (_e7219 < _e2326));
let _e7229 = global_5.member[bitcast<u32>(select(0i, _e7224, (_e7224 > 0i)))];
let _e7233 = (_e7219 + 1i);
let _e7235 = select(_e2326, _e7233, (_e7233 < _e2326));
let _e7240 = global_5.member[bitcast<u32>(select(0i, _e7235, (_e7235 > 0i)))];
let _e7247 = ((_e7229 >> bitcast<u32>((_e7222 & 31u))) | ((_e7240 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e7222) & 31u))));
let _e7250 = f32(bitcast<i32>((_e7247 & 65535u)));
let _e7257 = (_e7250 + ((f32(bitcast<i32>((_e7247 >> bitcast<u32>(16i)))) - _e7250) * _e7212));
let _e7259 = (2i * (_e7210 + _e7172));
let _e7261 = (_e7259 >> bitcast<u32>(2i));
let _e7264 = bitcast<u32>(((_e7259 & 3i) * 8i));
let _e7266 = select(_e2326, _e7261, (_e7261 < _e2326));
let _e7271 = global_5.member[bitcast<u32>(select(0i, _e7266, (_e7266 > 0i)))];
let _e7275 = (_e7261 + 1i);
let _e7277 = select(_e2326, _e7275, (_e7275 < _e2326));
let _e7282 = global_5.member[bitcast<u32>(select(0i, _e7277, (_e7277 > 0i)))];
let _e7289 = ((_e7271 >> bitcast<u32>((_e7264 & 31u))) | ((_e7282 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e7264) & 31u))));
let _e7292 = f32(bitcast<i32>((_e7289 & 65535u)));
let _e7300 = (_e7210 + _e7197);
let _e7301 = (2i * _e7300);
let _e7303 = (_e7301 >> bitcast<u32>(2i));
let _e7306 = bitcast<u32>(((_e7301 & 3i) * 8i));
let _e7308 = select(_e2326, _e7303, (_e7303 < _e2326));
let _e7313 = global_5.member[bitcast<u32>(select(0i, _e7308, (_e7308 > 0i)))];
let _e7317 = (_e7303 + 1i);
let _e7319 = select(_e2326, _e7317, (_e7317 < _e2326));
let _e7324 = global_5.member[bitcast<u32>(select(0i, _e7319, (_e7319 > 0i)))];
let _e7331 = ((_e7313 >> bitcast<u32>((_e7306 & 31u))) | ((_e7324 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e7306) & 31u))));
let _e7334 = f32(bitcast<i32>((_e7331 & 65535u)));
let _e7341 = (_e7334 + ((f32(bitcast<i32>((_e7331 >> bitcast<u32>(16i)))) - _e7334) * _e7212));
let _e7343 = (2i * (_e7300 + _e7172));
let _e7345 = (_e7343 >> bitcast<u32>(2i));
let _e7348 = bitcast<u32>(((_e7343 & 3i) * 8i));
let _e7350 = select(_e2326, _e7345, (_e7345 < _e2326));
let _e7355 = global_5.member[bitcast<u32>(select(0i, _e7350, (_e7350 > 0i)))];
let _e7359 = (_e7345 + 1i);
let _e7361 = select(_e2326, _e7359, (_e7359 < _e2326));
let _e7366 = global_5.member[bitcast<u32>(select(0i, _e7361, (_e7361 > 0i)))];
let _e7373 = ((_e7355 >> bitcast<u32>((_e7348 & 31u))) | ((_e7366 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e7348) & 31u))));
let _e7376 = f32(bitcast<i32>((_e7373 & 65535u)));
let _e7386 = (_e7257 + (((_e7292 + ((f32(bitcast<i32>((_e7289 >> bitcast<u32>(16i)))) - _e7292) * _e7212)) - _e7257) * _e7214));
phi_10355_ = (_e7386 + (((_e7341 + (((_e7376 + ((f32(bitcast<i32>((_e7373 >> bitcast<u32>(16i)))) - _e7376) * _e7212)) - _e7341) * _e7214)) - _e7386) * (_e7094 - f32(_e7139))));
} else {
phi_10355_ = 0f;
}
let _e7394 = phi_10355_;
let _e7395 = local;
let _e7396 = local_1[0u];
let _e7398 = local_1[1u];
let _e7400 = local_1[2u];
let _e7402 = ((_e7396 + 0f) - 0.5f);
let _e7403 = ((_e7398 + 1f) - 0.5f);
let _e7404 = ((_e7400 + 0f) - 0.5f);
let _e7406 = select(0f, _e7402, (_e7402 > 0f));
let _e7408 = select(_e2273, _e7406, (_e7406 < _e2273));
let _e7415 = select(0i, select(select(i32(_e7408), i32(-2147483648), (_e7408 < -2147483600f)), 2147483647i, (_e7408 > 2147483500f)), (_e7408 == _e7408));
let _e7419 = (_e7415 - select(0i, 1i, (_e7408 < f32(_e7415))));
let _e7421 = select(0f, _e7403, (_e7403 > 0f));
let _e7423 = select(_e2290, _e7421, (_e7421 < _e2290));
let _e7430 = select(0i, select(select(i32(_e7423), i32(-2147483648), (_e7423 < -2147483600f)), 2147483647i, (_e7423 > 2147483500f)), (_e7423 == _e7423));
let _e7434 = (_e7430 - select(0i, 1i, (_e7423 < f32(_e7430))));
let _e7436 = select(0f, _e7404, (_e7404 > 0f));
let _e7438 = select(_e2307, _e7436, (_e7436 < _e2307));
let _e7445 = select(0i, select(select(i32(_e7438), i32(-2147483648), (_e7438 < -2147483600f)), 2147483647i, (_e7438 > 2147483500f)), (_e7438 == _e7438));
let _e7449 = (_e7445 - select(0i, 1i, (_e7438 < f32(_e7445))));
let _e7450 = (_e7395 * 4i);
let _e7451 = (_e7450 + 1i);
let _e7453 = select(_e2326, _e7451, (_e7451 < _e2326));
let _e7458 = global_5.member[bitcast<u32>(select(0i, _e7453, (_e7453 > 0i)))];
let _e7459 = (_e7450 + 2i);
let _e7461 = select(_e2326, _e7459, (_e7459 < _e2326));
let _e7466 = global_5.member[bitcast<u32>(select(0i, _e7461, (_e7461 > 0i)))];
let _e7467 = (_e7450 + 3i);
let _e7469 = select(_e2326, _e7467, (_e7467 < _e2326));
let _e7474 = global_5.member[bitcast<u32>(select(0i, _e7469, (_e7469 > 0i)))];
let _e7477 = (_e7419 - bitcast<i32>((_e7458 & 65535u)));
let _e7482 = bitcast<i32>((_e7458 >> bitcast<u32>(16i)));
let _e7487 = (_e7434 - bitcast<i32>((_e7466 & 65535u)));
let _e7492 = bitcast<i32>((_e7466 >> bitcast<u32>(16i)));
let _e7497 = (_e7449 - bitcast<i32>((_e7474 & 65535u)));
if ((((_e7477 >= 0i) && ((_e7477 + 1i) < _e7482)) && ((_e7487 >= 0i) && ((_e7487 + 1i) < _e7492))) && ((_e7497 >= 0i) && ((_e7497 + 1i) < bitcast<i32>((_e7474 >> bitcast<u32>(16i)))))) {
let _e7507 = (_e7492 * _e7482);
let _e7509 = select(_e2326, _e7450, (_e7450 < _e2326));
let _e7514 = global_5.member[bitcast<u32>(select(0i, _e7509, (_e7509 > 0i)))];
let _e7520 = (((bitcast<i32>(_e7514) + (_e7497 * _e7507)) + (_e7487 * _e7482)) + _e7477);
let _e7522 = (_e7402 - f32(_e7419));
let _e7524 = (_e7403 - f32(_e7434));
let _e7527 = (2i * _e7520);
let _e7529 = (_e7527 >> bitcast<u32>(2i));
let _e7532 = bitcast<u32>(((_e7527 & 3i) * 8i));
let _e7534 = select(_e2326, _e7529, (_e7529 < _e2326));
let _e7539 = global_5.member[bitcast<u32>(select(0i, _e7534, (_e7534 > 0i)))];
let _e7543 = (_e7529 + 1i);
let _e7545 = select(_e2326, _e7543, (_e7543 < _e2326));
let _e7550 = global_5.member[bitcast<u32>(select(0i, _e7545, (_e7545 > 0i)))];
let _e7557 = ((_e7539 >> bitcast<u32>((_e7532 & 31u))) | ((_e7550 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e7532) & 31u))));
let _e7560 = f32(bitcast<i32>((_e7557 & 65535u)));
let _e7567 = (_e7560 + ((f32(bitcast<i32>((_e7557 >> bitcast<u32>(16i)))) - _e7560) * _e7522));
let _e7569 = (2i * (_e7520 + _e7482));
let _e7571 = (_e7569 >> bitcast<u32>(2i));
let _e7574 = bitcast<u32>(((_e7569 & 3i) * 8i));
let _e7576 = select(_e2326, _e7571, (_e7571 < _e2326));
let _e7581 = global_5.member[bitcast<u32>(select(0i, _e7576, (_e7576 > 0i)))];
let _e7585 = (_e7571 + 1i);
let _e7587 = select(_e2326, _e7585, (_e7585 < _e2326));
let _e7592 = global_5.member[bitcast<u32>(select(0i, _e7587, (_e7587 > 0i)))];
let _e7599 = ((_e7581 >> bitcast<u32>((_e7574 & 31u))) | ((_e7592 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e7574) & 31u))));
let _e7602 = f32(bitcast<i32>((_e7599 & 65535u)));
let _e7610 = (_e7520 + _e7507);
let _e7611 = (2i * _e7610);
let _e7613 = (_e7611 >> bitcast<u32>(2i));
let _e7616 = bitcast<u32>(((_e7611 & 3i) * 8i));
let _e7618 = select(_e2326, _e7613, (_e7613 < _e2326));
let _e7623 = global_5.member[bitcast<u32>(select(0i, _e7618, (_e7618 > 0i)))];
let _e7627 = (_e7613 + 1i);
let _e7629 = select(_e2326, _e7627, (_e7627 < _e2326));
let _e7634 = global_5.member[bitcast<u32>(select(0i, _e7629, (_e7629 > 0i)))];
let _e7641 = ((_e7623 >> bitcast<u32>((_e7616 & 31u))) | ((_e7634 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e7616) & 31u))));
let _e7644 = f32(bitcast<i32>((_e7641 & 65535u)));
let _e7651 = (_e7644 + ((f32(bitcast<i32>((_e7641 >> bitcast<u32>(16i)))) - _e7644) * _e7522));
let _e7653 = (2i * (_e7610 + _e7482));
let _e7655 = (_e7653 >> bitcast<u32>(2i));
let _e7658 = bitcast<u32>(((_e7653 & 3i) * 8i));
let _e7660 = select(_e2326, _e7655, (_e7655 < _e2326));
let _e7665 = global_5.member[bitcast<u32>(select(0i, _e7660, (_e7660 > 0i)))];
let _e7669 = (_e7655 + 1i);
let _e7671 = select(_e2326, _e7669, (_e7669 < _e2326));
let _e7676 = global_5.member[bitcast<u32>(select(0i, _e7671, (_e7671 > 0i)))];
let _e7683 = ((_e7665 >> bitcast<u32>((_e7658 & 31u))) | ((_e7676 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e7658) & 31u))));
let _e7686 = f32(bitcast<i32>((_e7683 & 65535u)));
let _e7696 = (_e7567 + (((_e7602 + ((f32(bitcast<i32>((_e7599 >> bitcast<u32>(16i)))) - _e7602) * _e7522)) - _e7567) * _e7524));
phi_10794_ = (_e7696 + (((_e7651 + (((_e7686 + ((f32(bitcast<i32>((_e7683 >> bitcast<u32>(16i)))) - _e7686) * _e7522)) - _e7651) * _e7524)) - _e7696) * (_e7404 - f32(_e7449))));
} else {
phi_10794_ = 0f;
}
let _e7704 = phi_10794_;
let _e7706 = local;
let _e7707 = local_1[0u];
let _e7709 = local_1[1u];
let _e7711 = local_1[2u];
let _e7713 = ((_e7707 + 0f) - 0.5f);
let _e7714 = ((_e7709 + 0f) - 0.5f);
let _e7715 = ((_e7711 + -1f) - 0.5f);
let _e7717 = select(0f, _e7713, (_e7713 > 0f));
let _e7719 = select(_e2273, _e7717, (_e7717 < _e2273));
let _e7726 = select(0i, select(select(i32(_e7719), i32(-2147483648), (_e7719 < -2147483600f)), 2147483647i, (_e7719 > 2147483500f)), (_e7719 == _e7719));
let _e7730 = (_e7726 - select(0i, 1i, (_e7719 < f32(_e7726))));
let _e7732 = select(0f, _e7714, (_e7714 > 0f));
let _e7734 = select(_e2290, _e7732, (_e7732 < _e2290));
let _e7741 = select(0i, select(select(i32(_e7734), i32(-2147483648), (_e7734 < -2147483600f)), 2147483647i, (_e7734 > 2147483500f)), (_e7734 == _e7734));
let _e7745 = (_e7741 - select(0i, 1i, (_e7734 < f32(_e7741))));
let _e7747 = select(0f, _e7715, (_e7715 > 0f));
let _e7749 = select(_e2307, _e7747, (_e7747 < _e2307));
let _e7756 = select(0i, select(select(i32(_e7749), i32(-2147483648), (_e7749 < -2147483600f)), 2147483647i, (_e7749 > 2147483500f)), (_e7749 == _e7749));
let _e7760 = (_e7756 - select(0i, 1i, (_e7749 < f32(_e7756))));
let _e7761 = (_e7706 * 4i);
let _e7762 = (_e7761 + 1i);
let _e7764 = select(_e2326, _e7762, (_e7762 < _e2326));
let _e7769 = global_5.member[bitcast<u32>(select(0i, _e7764, (_e7764 > 0i)))];
let _e7770 = (_e7761 + 2i);
let _e7772 = select(_e2326, _e7770, (_e7770 < _e2326));
let _e7777 = global_5.member[bitcast<u32>(select(0i, _e7772, (_e7772 > 0i)))];
let _e7778 = (_e7761 + 3i);
let _e7780 = select(_e2326, _e7778, (_e7778 < _e2326));
let _e7785 = global_5.member[bitcast<u32>(select(0i, _e7780, (_e7780 > 0i)))];
let _e7788 = (_e7730 - bitcast<i32>((_e7769 & 65535u)));
let _e7793 = bitcast<i32>((_e7769 >> bitcast<u32>(16i)));
let _e7798 = (_e7745 - bitcast<i32>((_e7777 & 65535u)));
let _e7803 = bitcast<i32>((_e7777 >> bitcast<u32>(16i)));
let _e7808 = (_e7760 - bitcast<i32>((_e7785 & 65535u)));
if ((((_e7788 >= 0i) && ((_e7788 + 1i) < _e7793)) && ((_e7798 >= 0i) && ((_e7798 + 1i) < _e7803))) && ((_e7808 >= 0i) && ((_e7808 + 1i) < bitcast<i32>((_e7785 >> bitcast<u32>(16i)))))) {
let _e7818 = (_e7803 * _e7793);
let _e7820 = select(_e2326, _e7761, (_e7761 < _e2326));
let _e7825 = global_5.member[bitcast<u32>(select(0i, _e7820, (_e7820 > 0i)))];
let _e7831 = (((bitcast<i32>(_e7825) + (_e7808 * _e7818)) + (_e7798 * _e7793)) + _e7788);
let _e7833 = (_e7713 - f32(_e7730));
let _e7835 = (_e7714 - f32(_e7745));
let _e7838 = (2i * _e7831);
let _e7840 = (_e7838 >> bitcast<u32>(2i));
let _e7843 = bitcast<u32>(((_e7838 & 3i) * 8i));
let _e7845 = select(_e2326, _e7840, (_e7840 < _e2326));
let _e7850 = global_5.member[bitcast<u32>(select(0i, _e7845, (_e7845 > 0i)))];
let _e7854 = (_e7840 + 1i);
let _e7856 = select(_e2326, _e7854, (_e7854 < _e2326));
let _e7861 = global_5.member[bitcast<u32>(select(0i, _e7856, (_e7856 > 0i)))];
let _e7868 = ((_e7850 >> bitcast<u32>((_e7843 & 31u))) | ((_e7861 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e7843) & 31u))));
let _e7871 = f32(bitcast<i32>((_e7868 & 65535u)));
let _e7878 = (_e7871 + ((f32(bitcast<i32>((_e7868 >> bitcast<u32>(16i)))) - _e7871) * _e7833));
let _e7880 = (2i * (_e7831 + _e7793));
let _e7882 = (_e7880 >> bitcast<u32>(2i));
let _e7885 = bitcast<u32>(((_e7880 & 3i) * 8i));
let _e7887 = select(_e2326, _e7882, (_e7882 < _e2326));
let _e7892 = global_5.member[bitcast<u32>(select(0i, _e7887, (_e7887 > 0i)))];
let _e7896 = (_e7882 + 1i);
let _e7898 = select(_e2326, _e7896, (_e7896 < _e2326));
let _e7903 = global_5.member[bitcast<u32>(select(0i, _e7898, (_e7898 > 0i)))];
let _e7910 = ((_e7892 >> bitcast<u32>((_e7885 & 31u))) | ((_e7903 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e7885) & 31u))));
let _e7913 = f32(bitcast<i32>((_e7910 & 65535u)));
let _e7921 = (_e7831 + _e7818);
let _e7922 = (2i * _e7921);
let _e7924 = (_e7922 >> bitcast<u32>(2i));
let _e7927 = bitcast<u32>(((_e7922 & 3i) * 8i));
let _e7929 = select(_e2326, _e7924, (_e7924 < _e2326));
let _e7934 = global_5.member[bitcast<u32>(select(0i, _e7929, (_e7929 > 0i)))];
let _e7938 = (_e7924 + 1i);
let _e7940 = select(_e2326, _e7938, (_e7938 < _e2326));
let _e7945 = global_5.member[bitcast<u32>(select(0i, _e7940, (_e7940 > 0i)))];
let _e7952 = ((_e7934 >> bitcast<u32>((_e7927 & 31u))) | ((_e7945 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e7927) & 31u))));
let _e7955 = f32(bitcast<i32>((_e7952 & 65535u)));
let _e7962 = (_e7955 + ((f32(bitcast<i32>((_e7952 >> bitcast<u32>(16i)))) - _e7955) * _e7833));
let _e7964 = (2i * (_e7921 + _e7793));
let _e7966 = (_e7964 >> bitcast<u32>(2i));
let _e7969 = bitcast<u32>(((_e7964 & 3i) * 8i));
let _e7971 = select(_e2326, _e7966, (_e7966 < _e2326));
let _e7976 = global_5.member[bitcast<u32>(select(0i, _e7971, (_e7971 > 0i)))];
let _e7980 = (_e7966 + 1i);
let _e7982 = select(_e2326, _e7980, (_e7980 < _e2326));
let _e7987 = global_5.member[bitcast<u32>(select(0i, _e7982, (_e7982 > 0i)))];
let _e7994 = ((_e7976 >> bitcast<u32>((_e7969 & 31u))) | ((_e7987 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e7969) & 31u))));
let _e7997 = f32(bitcast<i32>((_e7994 & 65535u)));
let _e8007 = (_e7878 + (((_e7913 + ((f32(bitcast<i32>((_e7910 >> bitcast<u32>(16i)))) - _e7913) * _e7833)) - _e7878) * _e7835));
phi_11234_ = (_e8007 + (((_e7962 + (((_e7997 + ((f32(bitcast<i32>((_e7994 >> bitcast<u32>(16i)))) - _e7997) * _e7833)) - _e7962) * _e7835)) - _e8007) * (_e7715 - f32(_e7760))));
} else {
phi_11234_ = 0f;
}
let _e8015 = phi_11234_;
let _e8016 = local;
let _e8017 = local_1[0u];
let _e8019 = local_1[1u];
let _e8021 = local_1[2u];
let _e8023 = ((_e8017 + 0f) - 0.5f);
let _e8024 = ((_e8019 + 0f) - 0.5f);
let _e8025 = ((_e8021 + 1f) - 0.5f);
let _e8027 = select(0f, _e8023, (_e8023 > 0f));
let _e8029 = select(_e2273, _e8027, (_e8027 < _e2273));
let _e8036 = select(0i, select(select(i32(_e8029), i32(-2147483648), (_e8029 < -2147483600f)), 2147483647i, (_e8029 > 2147483500f)), (_e8029 == _e8029));
let _e8040 = (_e8036 - select(0i, 1i, (_e8029 < f32(_e8036))));
let _e8042 = select(0f, _e8024, (_e8024 > 0f));
let _e8044 = select(_e2290, _e8042, (_e8042 < _e2290));
let _e8051 = select(0i, select(select(i32(_e8044), i32(-2147483648), (_e8044 < -2147483600f)), 2147483647i, (_e8044 > 2147483500f)), (_e8044 == _e8044));
let _e8055 = (_e8051 - select(0i, 1i, (_e8044 < f32(_e8051))));
let _e8057 = select(0f, _e8025, (_e8025 > 0f));
let _e8059 = select(_e2307, _e8057, (_e8057 < _e2307));
let _e8066 = select(0i, select(select(i32(_e8059), i32(-2147483648), (_e8059 < -2147483600f)), 2147483647i, (_e8059 > 2147483500f)), (_e8059 == _e8059));
let _e8070 = (_e8066 - select(0i, 1i, (_e8059 < f32(_e8066))));
let _e8071 = (_e8016 * 4i);
let _e8072 = (_e8071 + 1i);
let _e8074 = select(_e2326, _e8072, (_e8072 < _e2326));
let _e8079 = global_5.member[bitcast<u32>(select(0i, _e8074, (_e8074 > 0i)))];
let _e8080 = (_e8071 + 2i);
let _e8082 = select(_e2326, _e8080, (_e8080 < _e2326));
let _e8087 = global_5.member[bitcast<u32>(select(0i, _e8082, (_e8082 > 0i)))];
let _e8088 = (_e8071 + 3i);
let _e8090 = select(_e2326, _e8088, (_e8088 < _e2326));
let _e8095 = global_5.member[bitcast<u32>(select(0i, _e8090, (_e8090 > 0i)))];
let _e8098 = (_e8040 - bitcast<i32>((_e8079 & 65535u)));
let _e8103 = bitcast<i32>((_e8079 >> bitcast<u32>(16i)));
let _e8108 = (_e8055 - bitcast<i32>((_e8087 & 65535u)));
let _e8113 = bitcast<i32>((_e8087 >> bitcast<u32>(16i)));
let _e8118 = (_e8070 - bitcast<i32>((_e8095 & 65535u)));
if ((((_e8098 >= 0i) && ((_e8098 + 1i) < _e8103)) && ((_e8108 >= 0i) && ((_e8108 + 1i) < _e8113))) && ((_e8118 >= 0i) && ((_e8118 + 1i) < bitcast<i32>((_e8095 >> bitcast<u32>(16i)))))) {
let _e8128 = (_e8113 * _e8103);
let _e8130 = select(_e2326, _e8071, (_e8071 < _e2326));
let _e8135 = global_5.member[bitcast<u32>(select(0i, _e8130, (_e8130 > 0i)))];
let _e8141 = (((bitcast<i32>(_e8135) + (_e8118 * _e8128)) + (_e8108 * _e8103)) + _e8098);
let _e8143 = (_e8023 - f32(_e8040));
let _e8145 = (_e8024 - f32(_e8055));
let _e8148 = (2i * _e8141);
let _e8150 = (_e8148 >> bitcast<u32>(2i));
let _e8153 = bitcast<u32>(((_e8148 & 3i) * 8i));
let _e8155 = select(_e2326, _e8150, (_e8150 < _e2326));
let _e8160 = global_5.member[bitcast<u32>(select(0i, _e8155, (_e8155 > 0i)))];
let _e8164 = (_e8150 + 1i);
let _e8166 = select(_e2326, _e8164, (_e8164 < _e2326));
let _e8171 = global_5.member[bitcast<u32>(select(0i, _e8166, (_e8166 > 0i)))];
let _e8178 = ((_e8160 >> bitcast<u32>((_e8153 & 31u))) | ((_e8171 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e8153) & 31u))));
let _e8181 = f32(bitcast<i32>((_e8178 & 65535u)));
let _e8188 = (_e8181 + ((f32(bitcast<i32>((_e8178 >> bitcast<u32>(16i)))) - _e8181) * _e8143));
let _e8190 = (2i * (_e8141 + _e8103));
let _e8192 = (_e8190 >> bitcast<u32>(2i));
let _e8195 = bitcast<u32>(((_e8190 & 3i) * 8i));
let _e8197 = select(_e2326, _e8192, (_e8192 < _e2326));
let _e8202 = global_5.member[bitcast<u32>(select(0i, _e8197, (_e8197 > 0i)))];
let _e8206 = (_e8192 + 1i);
let _e8208 = select(_e2326, _e8206, (_e8206 < _e2326));
let _e8213 = global_5.member[bitcast<u32>(select(0i, _e8208, (_e8208 > 0i)))];
let _e8220 = ((_e8202 >> bitcast<u32>((_e8195 & 31u))) | ((_e8213 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e8195) & 31u))));
let _e8223 = f32(bitcast<i32>((_e8220 & 65535u)));
let _e8231 = (_e8141 + _e8128);
let _e8232 = (2i * _e8231);
let _e8234 = (_e8232 >> bitcast<u32>(2i));
let _e8237 = bitcast<u32>(((_e8232 & 3i) * 8i));
let _e8239 = select(_e2326, _e8234, (_e8234 < _e2326));
let _e8244 = global_5.member[bitcast<u32>(select(0i, _e8239, (_e8239 > 0i)))];
let _e8248 = (_e8234 + 1i);
let _e8250 = select(_e2326, _e8248, (_e8248 < _e2326));
let _e8255 = global_5.member[bitcast<u32>(select(0i, _e8250, (_e8250 > 0i)))];
let _e8262 = ((_e8244 >> bitcast<u32>((_e8237 & 31u))) | ((_e8255 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e8237) & 31u))));
let _e8265 = f32(bitcast<i32>((_e8262 & 65535u)));
let _e8272 = (_e8265 + ((f32(bitcast<i32>((_e8262 >> bitcast<u32>(16i)))) - _e8265) * _e8143));
let _e8274 = (2i * (_e8231 + _e8103));
let _e8276 = (_e8274 >> bitcast<u32>(2i));
let _e8279 = bitcast<u32>(((_e8274 & 3i) * 8i));
let _e8281 = select(_e2326, _e8276, (_e8276 < _e2326));
let _e8286 = global_5.member[bitcast<u32>(select(0i, _e8281, (_e8281 > 0i)))];
let _e8290 = (_e8276 + 1i);
let _e8292 = select(_e2326, _e8290, (_e8290 < _e2326));
let _e8297 = global_5.member[bitcast<u32>(select(0i, _e8292, (_e8292 > 0i)))];
let _e8304 = ((_e8286 >> bitcast<u32>((_e8279 & 31u))) | ((_e8297 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e8279) & 31u))));
let _e8307 = f32(bitcast<i32>((_e8304 & 65535u)));
let _e8317 = (_e8188 + (((_e8223 + ((f32(bitcast<i32>((_e8220 >> bitcast<u32>(16i)))) - _e8223) * _e8143)) - _e8188) * _e8145));
phi_11673_ = (_e8317 + (((_e8272 + (((_e8307 + ((f32(bitcast<i32>((_e8304 >> bitcast<u32>(16i)))) - _e8307) * _e8143)) - _e8272) * _e8145)) - _e8317) * (_e8025 - f32(_e8070))));
} else {
phi_11673_ = 0f;
}
let _e8325 = phi_11673_;
let _e8327 = ((_e6773 - _e7083) * _e4133);
let _e8328 = ((_e7394 - _e7704) * _e4133);
let _e8329 = ((_e8015 - _e8325) * _e4133);
let _e8334 = (((_e8327 * _e8327) + (_e8328 * _e8328)) + (_e8329 * _e8329));
let _e8337 = sqrt(select(0f, _e8334, (_e8334 > 0f)));
let _e8340 = (1f / select(1e-6f, _e8337, (_e8337 > 1e-6f)));
let _e8341 = (_e8327 * _e8340);
let _e8342 = (_e8328 * _e8340);
let _e8343 = (_e8329 * _e8340);
let _e8345 = (_e6457 - 0.5f);
let _e8346 = (_e6458 - 0.5f);
let _e8347 = (_e6459 - 0.5f);
let _e8349 = select(0f, _e8345, (_e8345 > 0f));
let _e8351 = select(_e6126, _e8349, (_e8349 < _e6126));
let _e8358 = select(0i, select(select(i32(_e8351), i32(-2147483648), (_e8351 < -2147483600f)), 2147483647i, (_e8351 > 2147483500f)), (_e8351 == _e8351));
let _e8362 = (_e8358 - select(0i, 1i, (_e8351 < f32(_e8358))));
let _e8364 = select(0f, _e8346, (_e8346 > 0f));
let _e8366 = select(_e6143, _e8364, (_e8364 < _e6143));
let _e8373 = select(0i, select(select(i32(_e8366), i32(-2147483648), (_e8366 < -2147483600f)), 2147483647i, (_e8366 > 2147483500f)), (_e8366 == _e8366));
let _e8377 = (_e8373 - select(0i, 1i, (_e8366 < f32(_e8373))));
let _e8379 = select(0f, _e8347, (_e8347 > 0f));
let _e8381 = select(_e6160, _e8379, (_e8379 < _e6160));
let _e8388 = select(0i, select(select(i32(_e8381), i32(-2147483648), (_e8381 < -2147483600f)), 2147483647i, (_e8381 > 2147483500f)), (_e8381 == _e8381));
let _e8392 = (_e8388 - select(0i, 1i, (_e8381 < f32(_e8388))));
let _e8393 = (_e8362 - _e6205);
let _e8398 = (_e8377 - _e6215);
let _e8403 = (_e8392 - _e6225);
if ((((_e8393 >= 0i) && ((_e8393 + 1i) < _e6211)) && ((_e8398 >= 0i) && ((_e8398 + 1i) < _e6221))) && ((_e8403 >= 0i) && ((_e8403 + 1i) < _e6231))) {
let _e8410 = (_e6221 * _e6211);
let _e8412 = select(_e2326, _e6176, (_e6176 < _e2326));
let _e8418 = global_5.member[bitcast<u32>(select(0i, _e8412, (_e8412 > 0i)))];
let _e8424 = (((bitcast<i32>(_e8418) + (_e8403 * _e8410)) + (_e8398 * _e6211)) + _e8393);
let _e8426 = (_e8345 - f32(_e8362));
let _e8428 = (_e8346 - f32(_e8377));
let _e8431 = (2i * _e8424);
let _e8433 = (_e8431 >> bitcast<u32>(2i));
let _e8436 = bitcast<u32>(((_e8431 & 3i) * 8i));
let _e8438 = select(_e2326, _e8433, (_e8433 < _e2326));
let _e8444 = global_5.member[bitcast<u32>(select(0i, _e8438, (_e8438 > 0i)))];
let _e8448 = (_e8433 + 1i);
let _e8450 = select(_e2326, _e8448, (_e8448 < _e2326));
let _e8456 = global_5.member[bitcast<u32>(select(0i, _e8450, (_e8450 > 0i)))];
let _e8463 = ((_e8444 >> bitcast<u32>((_e8436 & 31u))) | ((_e8456 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e8436) & 31u))));
let _e8466 = f32(bitcast<i32>((_e8463 & 65535u)));
let _e8473 = (_e8466 + ((f32(bitcast<i32>((_e8463 >> bitcast<u32>(16i)))) - _e8466) * _e8426));
let _e8475 = (2i * (_e8424 + _e6211));
let _e8477 = (_e8475 >> bitcast<u32>(2i));
let _e8480 = bitcast<u32>(((_e8475 & 3i) * 8i));
let _e8482 = select(_e2326, _e8477, (_e8477 < _e2326));
let _e8488 = global_5.member[bitcast<u32>(select(0i, _e8482, (_e8482 > 0i)))];
let _e8492 = (_e8477 + 1i);
let _e8494 = select(_e2326, _e8492, (_e8492 < _e2326));
let _e8500 = global_5.member[bitcast<u32>(select(0i, _e8494, (_e8494 > 0i)))];
let _e8507 = ((_e8488 >> bitcast<u32>((_e8480 & 31u))) | ((_e8500 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e8480) & 31u))));
let _e8510 = f32(bitcast<i32>((_e8507 & 65535u)));
let _e8518 = (_e8424 + _e8410);
let _e8519 = (2i * _e8518);
let _e8521 = (_e8519 >> bitcast<u32>(2i));
let _e8524 = bitcast<u32>(((_e8519 & 3i) * 8i));
let _e8526 = select(_e2326, _e8521, (_e8521 < _e2326));
let _e8532 = global_5.member[bitcast<u32>(select(0i, _e8526, (_e8526 > 0i)))];
let _e8536 = (_e8521 + 1i);
let _e8538 = select(_e2326, _e8536, (_e8536 < _e2326));
let _e8544 = global_5.member[bitcast<u32>(select(0i, _e8538, (_e8538 > 0i)))];
let _e8551 = ((_e8532 >> bitcast<u32>((_e8524 & 31u))) | ((_e8544 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e8524) & 31u))));
let _e8554 = f32(bitcast<i32>((_e8551 & 65535u)));
let _e8561 = (_e8554 + ((f32(bitcast<i32>((_e8551 >> bitcast<u32>(16i)))) - _e8554) * _e8426));
let _e8563 = (2i * (_e8518 + _e6211));
let _e8565 = (_e8563 >> bitcast<u32>(2i));
let _e8568 = bitcast<u32>(((_e8563 & 3i) * 8i));
let _e8570 = select(_e2326, _e8565, (_e8565 < _e2326));
let _e8576 = global_5.member[bitcast<u32>(select(0i, _e8570, (_e8570 > 0i)))];
let _e8580 = (_e8565 + 1i);
let _e8582 = select(_e2326, _e8580, (_e8580 < _e2326));
let _e8588 = global_5.member[bitcast<u32>(select(0i, _e8582, (_e8582 > 0i)))];
let _e8595 = ((_e8576 >> bitcast<u32>((_e8568 & 31u))) | ((_e8588 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e8568) & 31u))));
let _e8598 = f32(bitcast<i32>((_e8595 & 65535u)));
let _e8608 = (_e8473 + (((_e8510 + ((f32(bitcast<i32>((_e8507 >> bitcast<u32>(16i)))) - _e8510) * _e8426)) - _e8473) * _e8428));
phi_12128_ = (_e8608 + (((_e8561 + (((_e8598 + ((f32(bitcast<i32>((_e8595 >> bitcast<u32>(16i)))) - _e8598) * _e8426)) - _e8561) * _e8428)) - _e8608) * (_e8347 - f32(_e8392))));
} else {
phi_12128_ = 0f;
}
let _e8616 = phi_12128_;
let _e8627 = (((32767.5f - _e8616) * _e6444) + (((_e8341 * (_e1885 - _e6457)) + (_e8342 * (_e1886 - _e6458))) + (_e8343 * (_e1887 - _e6459))));
let _e8628 = (_e8341 - _e4134);
let _e8629 = (_e8342 - _e4135);
let _e8630 = (_e8343 - _e4136);
let _e8640 = (((_e8628 * _e8628) + (_e8629 * _e8629)) + (_e8630 * _e8630));
let _e8650 = (((_e8341 * _e919.member_1.x) + (_e8342 * _e919.member_1.y)) + (_e8343 * _e919.member_1.z));
let _e8654 = (-(_e8627) / select(_e8650, 1f, (_e8650 == 0f)));
let _e8667 = bitcast<f32>((bitcast<u32>(_e8654) & 2147483647u));
let _e8669 = ((((_e8337 >= 0.998f) && ((((_e8628 * _e8341) + (_e8629 * _e8342)) + (_e8630 * _e8343)) >= (0.38268343f * sqrt(select(0f, _e8640, (_e8640 > 0f)))))) && (((_e8650 * (((_e4148 * _e919.member_1.x) + (_e4149 * _e919.member_1.y)) + (_e4150 * _e919.member_1.z))) > 0f) && (bitcast<f32>((bitcast<u32>(_e8627) & 2147483647u)) < 0.8f))) && (_e8667 < _e4214));
if _e8669 {
phi_12200_ = type_28(vec3<f32>(_e8341, _e8342, _e8343), _e8654);
} else {
phi_12200_ = _e4220;
}
let _e8672 = phi_12200_;
phi_5895_ = ((_e4218 + _e4212) * 0.70710677f);
phi_5898_ = select(_e4214, _e8667, _e8669);
phi_5900_ = (_e4216 + 1i);
phi_5902_ = ((_e4218 - _e4212) * 0.70710677f);
phi_5904_ = _e8672;
} else {
phi_5895_ = f32();
phi_5898_ = f32();
phi_5900_ = i32();
phi_5902_ = f32();
phi_5904_ = type_28();
}
let _e8680 = phi_5895_;
let _e8682 = phi_5898_;
let _e8684 = phi_5900_;
let _e8686 = phi_5902_;
let _e8688 = phi_5904_;
continue;
continuing {
phi_5894_ = _e8680;
phi_5897_ = _e8682;
phi_5899_ = _e8684;
phi_5901_ = _e8686;
phi_5903_ = _e8688;
break if !(_e4221);
}
}
let _e11196 = local_54;
phi_12206_ = _e11196;
}
let _e8692 = phi_12206_;
let _e8696 = local_14;
let _e8700 = global_1.member.member_13;
let _e8716 = global_1.member.member_12;
let _e8720 = local_15;
let _e8722 = ((((_e919.member_5 + _e8696) < _e8700) && ((((_e8692.member.x * _e919.member_4.x) + (_e8692.member.y * _e919.member_4.y)) + (_e8692.member.z * _e919.member_4.z)) > _e8716)) || (_e8720 == _e919.member_7));
if _e8722 {
phi_13735_ = _e919;
} else {
let _e8725 = local_16;
let _e8726 = (_e8725 + _e8692.member_1);
let _e8757 = type_25(vec3<f32>((_e919.member.x + (_e919.member_1.x * _e8726)), (_e919.member.y + (_e919.member_1.y * _e8726)), (_e919.member.z + (_e919.member_1.z * _e8726))), _e919.member_1, _e919.member_2, _e919.member_3, _e919.member_4, _e919.member_5, _e919.member_6, _e919.member_7, _e919.member_8, _e919.member_9, _e919.member_10, _e919.member_11, _e919.member_12, _e919.member_13, _e919.member_14, _e919.member_15, _e919.member_16, _e919.member_17);
let _e8776 = type_25(_e8757.member, _e8757.member_1, _e8757.member_2, _e8757.member_3, _e8757.member_4, (_e919.member_5 + _e8726), _e8757.member_6, _e8757.member_7, _e8757.member_8, _e8757.member_9, _e8757.member_10, _e8757.member_11, _e8757.member_12, _e8757.member_13, _e8757.member_14, _e8757.member_15, _e8757.member_16, _e8757.member_17);
let _e8799 = type_25(_e8776.member, _e8776.member_1, _e8776.member_2, _e8776.member_3, _e8776.member_4, _e8776.member_5, _e8776.member_6, _e8776.member_7, _e8776.member_8, _e8776.member_9, (_e919.member_10 + select(0f, _e8726, (_e919.member_8 == 0f))), _e8776.member_11, _e8776.member_12, _e8776.member_13, _e8776.member_14, _e8776.member_15, _e8776.member_16, _e8776.member_17);
if (_e919.member_7 != 16i) {
let _e8820 = type_25(_e8799.member, _e8799.member_1, _e8799.member_2, _e8799.member_3, _e8799.member_4, _e8799.member_5, _e8799.member_6, _e8799.member_7, _e8799.member_8, (_e919.member_9 + _e8726), _e8799.member_10, _e8799.member_11, _e8799.member_12, _e8799.member_13, _e8799.member_14, _e8799.member_15, _e8799.member_16, _e8799.member_17);
let _e8821 = (_e919.member_7 * 4i);
let _e8822 = (_e8821 + 1i);
let _e8824 = (bitcast<i32>(_e118) - 1i);
let _e8826 = select(_e8824, _e8822, (_e8822 < _e8824));
let _e8832 = global_2.member[bitcast<u32>(select(0i, _e8826, (_e8826 > 0i)))];
let _e8834 = -((_e8832 * _e8726));
let _e8836 = select(-87f, _e8834, (_e8834 > -87f));
let _e8838 = select(88f, _e8836, (_e8836 < 88f));
let _e8840 = ((_e8838 * 1.442695f) + 0.5f);
let _e8842 = select(-127f, _e8840, (_e8840 > -127f));
let _e8844 = select(128f, _e8842, (_e8842 < 128f));
let _e8851 = select(0i, select(select(i32(_e8844), i32(-2147483648), (_e8844 < -2147483600f)), 2147483647i, (_e8844 > 2147483500f)), (_e8844 == _e8844));
let _e8855 = (_e8851 - select(0i, 1i, (_e8844 < f32(_e8851))));
let _e8856 = f32(_e8855);
let _e8860 = ((_e8838 - (_e8856 * 0.6933594f)) - (_e8856 * -2.1219444e-4f));
let _e8881 = (_e8821 + 2i);
let _e8883 = select(_e8824, _e8881, (_e8881 < _e8824));
let _e8889 = global_2.member[bitcast<u32>(select(0i, _e8883, (_e8883 > 0i)))];
let _e8891 = -((_e8889 * _e8726));
let _e8893 = select(-87f, _e8891, (_e8891 > -87f));
let _e8895 = select(88f, _e8893, (_e8893 < 88f));
let _e8897 = ((_e8895 * 1.442695f) + 0.5f);
let _e8899 = select(-127f, _e8897, (_e8897 > -127f));
let _e8901 = select(128f, _e8899, (_e8899 < 128f));
let _e8908 = select(0i, select(select(i32(_e8901), i32(-2147483648), (_e8901 < -2147483600f)), 2147483647i, (_e8901 > 2147483500f)), (_e8901 == _e8901));
let _e8912 = (_e8908 - select(0i, 1i, (_e8901 < f32(_e8908))));
let _e8913 = f32(_e8912);
let _e8917 = ((_e8895 - (_e8913 * 0.6933594f)) - (_e8913 * -2.1219444e-4f));
let _e8938 = (_e8821 + 3i);
let _e8940 = select(_e8824, _e8938, (_e8938 < _e8824));
let _e8946 = global_2.member[bitcast<u32>(select(0i, _e8940, (_e8940 > 0i)))];
let _e8948 = -((_e8946 * _e8726));
let _e8950 = select(-87f, _e8948, (_e8948 > -87f));
let _e8952 = select(88f, _e8950, (_e8950 < 88f));
let _e8954 = ((_e8952 * 1.442695f) + 0.5f);
let _e8956 = select(-127f, _e8954, (_e8954 > -127f));
let _e8958 = select(128f, _e8956, (_e8956 < 128f));
let _e8965 = select(0i, select(select(i32(_e8958), i32(-2147483648), (_e8958 < -2147483600f)), 2147483647i, (_e8958 > 2147483500f)), (_e8958 == _e8958));
let _e8969 = (_e8965 - select(0i, 1i, (_e8958 < f32(_e8965))));
let _e8970 = f32(_e8969);
let _e8974 = ((_e8952 - (_e8970 * 0.6933594f)) - (_e8970 * -2.1219444e-4f));
phi_12520_ = type_25(_e8820.member, _e8820.member_1, vec3<f32>((_e919.member_2.x * ((1f + (_e8860 * (1f + (_e8860 * (0.5f + (_e8860 * (0.16666667f + (_e8860 * (0.041666668f + (_e8860 * (0.008333334f + (_e8860 * (0.001388889f + (_e8860 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e8855 + 127i)) << bitcast<u32>(23i))))), (_e919.member_2.y * ((1f + (_e8917 * (1f + (_e8917 * (0.5f + (_e8917 * (0.16666667f + (_e8917 * (0.041666668f + (_e8917 * (0.008333334f + (_e8917 * (0.001388889f + (_e8917 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e8912 + 127i)) << bitcast<u32>(23i))))), (_e919.member_2.z * ((1f + (_e8974 * (1f + (_e8974 * (0.5f + (_e8974 * (0.16666667f + (_e8974 * (0.041666668f + (_e8974 * (0.008333334f + (_e8974 * (0.001388889f + (_e8974 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e8969 + 127i)) << bitcast<u32>(23i)))))), _e8820.member_3, _e8820.member_4, _e8820.member_5, _e8820.member_6, _e8820.member_7, _e8820.member_8, _e8820.member_9, _e8820.member_10, _e8820.member_11, _e8820.member_12, _e8820.member_13, _e8820.member_14, _e8820.member_15, _e8820.member_16, _e8820.member_17);
} else {
phi_12520_ = _e8799;
}
let _e9024 = phi_12520_;
let _e9026 = (_e919.member_7 * 4i);
let _e9028 = (bitcast<i32>(_e118) - 1i);
let _e9030 = select(_e9028, _e9026, (_e9026 < _e9028));
let _e9036 = global_2.member[bitcast<u32>(select(0i, _e9030, (_e9030 > 0i)))];
let _e9037 = (_e919.member_7 == 16i);
let _e9038 = select(_e9036, 1f, _e9037);
let _e9040 = local_17;
let _e9041 = (_e9040 * 4i);
let _e9043 = select(_e9028, _e9041, (_e9041 < _e9028));
let _e9049 = global_2.member[bitcast<u32>(select(0i, _e9043, (_e9043 > 0i)))];
let _e9051 = local_18;
let _e9053 = select(_e9049, 1f, (_e9051 == 16i));
let _e9063 = select(1f, -1f, ((((_e9024.member_1.x * _e8692.member.x) + (_e9024.member_1.y * _e8692.member.y)) + (_e9024.member_1.z * _e8692.member.z)) > 0f));
let _e9064 = (_e8692.member.x * _e9063);
let _e9065 = (_e8692.member.y * _e9063);
let _e9066 = (_e8692.member.z * _e9063);
let _e9072 = -((((_e9024.member_1.x * _e9064) + (_e9024.member_1.y * _e9065)) + (_e9024.member_1.z * _e9066)));
let _e9074 = select(0f, _e9072, (_e9072 > 0f));
let _e9075 = (_e9038 / _e9053);
let _e9077 = (_e9074 * _e9074);
let _e9080 = (1f - ((_e9075 * _e9075) * (1f - _e9077)));
let _e9081 = (_e9080 <= 0f);
let _e9089 = ((_e9075 * _e9074) - sqrt(select(0f, _e9080, (_e9080 > 0f))));
let _e9096 = (2f * _e9074);
let _e9100 = (_e9024.member_1.x + (_e9064 * _e9096));
let _e9101 = (_e9024.member_1.y + (_e9065 * _e9096));
let _e9102 = (_e9024.member_1.z + (_e9066 * _e9096));
let _e9103 = select(((_e9024.member_1.x * _e9075) + (_e9064 * _e9089)), _e9100, _e9081);
let _e9104 = select(((_e9024.member_1.y * _e9075) + (_e9065 * _e9089)), _e9101, _e9081);
let _e9105 = select(((_e9024.member_1.z * _e9075) + (_e9066 * _e9089)), _e9102, _e9081);
let _e9110 = (((_e9103 * _e9103) + (_e9104 * _e9104)) + (_e9105 * _e9105));
let _e9113 = sqrt(select(0f, _e9110, (_e9110 > 0f)));
let _e9116 = (1f / select(1e-20f, _e9113, (_e9113 > 1e-20f)));
let _e9121 = (_e9053 / _e9038);
let _e9124 = (((_e9121 * _e9121) - 1f) + _e9077);
let _e9127 = sqrt(select(0f, _e9124, (_e9124 > 0f)));
let _e9128 = (_e9127 - _e9074);
let _e9129 = (_e9127 + _e9074);
let _e9132 = (_e9128 / select(1e-6f, _e9129, (_e9129 > 1e-6f)));
let _e9136 = ((_e9074 * _e9128) + 1f);
let _e9139 = (((_e9074 * _e9129) - 1f) / select(1e-6f, _e9136, (_e9136 > 1e-6f)));
let _e9150 = (_e9024.member_8 == 0f);
let _e9153 = global_1.member.member_1;
let _e9156 = select(0f, select(select((((0.5f * _e9132) * _e9132) * (1f + (_e9139 * _e9139))), 1f, (_e9124 <= 0f)), 0f, (_e9038 == _e9053)), ((_e9153 & 1u) != 0u));
let _e9157 = (_e9150 && _e9037);
if _e9150 {
let _e9175 = type_25(_e9024.member, _e9024.member_1, _e9024.member_2, _e8692.member, _e9024.member_4, _e9024.member_5, _e9024.member_6, _e9024.member_7, _e9024.member_8, _e9024.member_9, _e9024.member_10, _e9024.member_11, _e9024.member_12, _e9024.member_13, _e9024.member_14, _e9024.member_15, _e9024.member_16, _e9024.member_17);
phi_12743_ = type_25(_e9175.member, _e9175.member_1, _e9175.member_2, _e9175.member_3, _e9175.member_4, _e9175.member_5, _e9175.member_6, _e9175.member_7, _e9175.member_8, _e9175.member_9, _e9175.member_10, select(0f, _e9156, _e9157), _e9175.member_12, _e9175.member_13, _e9175.member_14, _e9175.member_15, _e9175.member_16, _e9175.member_17);
} else {
phi_12743_ = _e9024;
}
let _e9196 = phi_12743_;
let _e9200 = select(24f, _e9196.member_8, (_e9196.member_8 < 24f));
let _e9210 = (_e9196.member_14 >> bitcast<u32>((select(0i, select(select(i32(_e9200), i32(-2147483648), (_e9200 < -2147483600f)), 2147483647i, (_e9200 > 2147483500f)), (_e9200 == _e9200)) & 31i)));
let _e9212 = ((_e9210 & 1i) == 1i);
if ((!(_e9157) && !(_e9081)) && (_e9210 == 0i)) {
let _e9221 = select(_e9196.member_5, _e9196.member_9, (_e9196.member_8 == 0f));
let _e9222 = (_e9026 + 1i);
let _e9224 = select(_e9028, _e9222, (_e9222 < _e9028));
let _e9230 = global_2.member[bitcast<u32>(select(0i, _e9224, (_e9224 > 0i)))];
let _e9232 = -((_e9230 * _e9221));
let _e9234 = select(-87f, _e9232, (_e9232 > -87f));
let _e9236 = select(88f, _e9234, (_e9234 < 88f));
let _e9238 = ((_e9236 * 1.442695f) + 0.5f);
let _e9240 = select(-127f, _e9238, (_e9238 > -127f));
let _e9242 = select(128f, _e9240, (_e9240 < 128f));
let _e9249 = select(0i, select(select(i32(_e9242), i32(-2147483648), (_e9242 < -2147483600f)), 2147483647i, (_e9242 > 2147483500f)), (_e9242 == _e9242));
let _e9253 = (_e9249 - select(0i, 1i, (_e9242 < f32(_e9249))));
let _e9254 = f32(_e9253);
let _e9258 = ((_e9236 - (_e9254 * 0.6933594f)) - (_e9254 * -2.1219444e-4f));
let _e9279 = (_e9026 + 2i);
let _e9281 = select(_e9028, _e9279, (_e9279 < _e9028));
let _e9287 = global_2.member[bitcast<u32>(select(0i, _e9281, (_e9281 > 0i)))];
let _e9289 = -((_e9287 * _e9221));
let _e9291 = select(-87f, _e9289, (_e9289 > -87f));
let _e9293 = select(88f, _e9291, (_e9291 < 88f));
let _e9295 = ((_e9293 * 1.442695f) + 0.5f);
let _e9297 = select(-127f, _e9295, (_e9295 > -127f));
let _e9299 = select(128f, _e9297, (_e9297 < 128f));
let _e9306 = select(0i, select(select(i32(_e9299), i32(-2147483648), (_e9299 < -2147483600f)), 2147483647i, (_e9299 > 2147483500f)), (_e9299 == _e9299));
let _e9310 = (_e9306 - select(0i, 1i, (_e9299 < f32(_e9306))));
let _e9311 = f32(_e9310);
let _e9315 = ((_e9293 - (_e9311 * 0.6933594f)) - (_e9311 * -2.1219444e-4f));
let _e9336 = (_e9026 + 3i);
let _e9338 = select(_e9028, _e9336, (_e9336 < _e9028));
let _e9344 = global_2.member[bitcast<u32>(select(0i, _e9338, (_e9338 > 0i)))];
let _e9346 = -((_e9344 * _e9221));
let _e9348 = select(-87f, _e9346, (_e9346 > -87f));
let _e9350 = select(88f, _e9348, (_e9348 < 88f));
let _e9352 = ((_e9350 * 1.442695f) + 0.5f);
let _e9354 = select(-127f, _e9352, (_e9352 > -127f));
let _e9356 = select(128f, _e9354, (_e9354 < 128f));
let _e9363 = select(0i, select(select(i32(_e9356), i32(-2147483648), (_e9356 < -2147483600f)), 2147483647i, (_e9356 > 2147483500f)), (_e9356 == _e9356));
let _e9367 = (_e9363 - select(0i, 1i, (_e9356 < f32(_e9363))));
let _e9368 = f32(_e9367);
let _e9372 = ((_e9350 - (_e9368 * 0.6933594f)) - (_e9368 * -2.1219444e-4f));
let _e9394 = select(((1f + (_e9258 * (1f + (_e9258 * (0.5f + (_e9258 * (0.16666667f + (_e9258 * (0.041666668f + (_e9258 * (0.008333334f + (_e9258 * (0.001388889f + (_e9258 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e9253 + 127i)) << bitcast<u32>(23i)))), 1f, _e9037);
let _e9396 = (1f - (_e9156 * _e9394));
let _e9398 = (1f - _e9156);
let _e9404 = select(((1f + (_e9315 * (1f + (_e9315 * (0.5f + (_e9315 * (0.16666667f + (_e9315 * (0.041666668f + (_e9315 * (0.008333334f + (_e9315 * (0.001388889f + (_e9315 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e9310 + 127i)) << bitcast<u32>(23i)))), 1f, _e9037);
let _e9406 = (1f - (_e9156 * _e9404));
let _e9413 = select(((1f + (_e9372 * (1f + (_e9372 * (0.5f + (_e9372 * (0.16666667f + (_e9372 * (0.041666668f + (_e9372 * (0.008333334f + (_e9372 * (0.001388889f + (_e9372 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e9367 + 127i)) << bitcast<u32>(23i)))), 1f, _e9037);
let _e9415 = (1f - (_e9156 * _e9413));
let _e9428 = ((_e9196.member_2.x * select(1f, ((_e9398 * _e9394) / select(1e-9f, _e9396, (_e9396 > 1e-9f))), (_e9396 > 0f))) * _e9156);
let _e9429 = ((_e9196.member_2.y * select(1f, ((_e9398 * _e9404) / select(1e-9f, _e9406, (_e9406 > 1e-9f))), (_e9406 > 0f))) * _e9156);
let _e9430 = ((_e9196.member_2.z * select(1f, ((_e9398 * _e9413) / select(1e-9f, _e9415, (_e9415 > 1e-9f))), (_e9415 > 0f))) * _e9156);
let _e9438 = select(0i, select(select(i32(_e9196.member_8), i32(-2147483648), (_e9196.member_8 < -2147483600f)), 2147483647i, (_e9196.member_8 > 2147483500f)), (_e9196.member_8 == _e9196.member_8));
let _e9450 = ((_e9196.member_13.x + _e9196.member_13.y) + _e9196.member_13.z);
if ((((_e9153 & 8u) != 0u) && (_e9438 < 24i)) && (((_e9428 + _e9429) + _e9430) > _e9450)) {
if (_e9450 > 0f) {
if (_e9196.member_14 == 0i) {
phi_13141_ = 0i;
} else {
phi_13141_ = (_e9196.member_14 - (1i << bitcast<u32>(((bitcast<i32>((bitcast<u32>(f32(_e9196.member_14)) >> bitcast<u32>(23i))) - 127i) & 31i))));
}
let _e9494 = phi_13141_;
phi_13143_ = _e9494;
} else {
phi_13143_ = _e9196.member_14;
}
let _e9496 = phi_13143_;
let _e9518 = type_25(_e9196.member, _e9196.member_1, _e9196.member_2, _e9196.member_3, _e9196.member_4, _e9196.member_5, _e9196.member_6, _e9196.member_7, _e9196.member_8, _e9196.member_9, _e9196.member_10, _e9196.member_11, _e9196.member_12, _e9196.member_13, (_e9496 | (1i << bitcast<u32>((_e9438 & 31i)))), _e9196.member_15, _e9196.member_16, _e9196.member_17);
let _e9546 = type_25(_e9518.member, _e9518.member_1, _e9518.member_2, _e9518.member_3, _e9518.member_4, _e9518.member_5, _e9518.member_6, _e9518.member_7, _e9518.member_8, _e9518.member_9, _e9518.member_10, _e9518.member_11, vec3<f32>((_e9196.member_12.x + _e9196.member_13.x), (_e9196.member_12.y + _e9196.member_13.y), (_e9196.member_12.z + _e9196.member_13.z)), _e9518.member_13, _e9518.member_14, _e9518.member_15, _e9518.member_16, _e9518.member_17);
phi_13171_ = type_25(_e9546.member, _e9546.member_1, _e9546.member_2, _e9546.member_3, _e9546.member_4, _e9546.member_5, _e9546.member_6, _e9546.member_7, _e9546.member_8, _e9546.member_9, _e9546.member_10, _e9546.member_11, _e9546.member_12, vec3<f32>(_e9428, _e9429, _e9430), _e9546.member_14, _e9546.member_15, _e9546.member_16, _e9546.member_17);
} else {
phi_13171_ = type_25(_e9196.member, _e9196.member_1, _e9196.member_2, _e9196.member_3, _e9196.member_4, _e9196.member_5, _e9196.member_6, _e9196.member_7, _e9196.member_8, _e9196.member_9, _e9196.member_10, _e9196.member_11, vec3<f32>((_e9196.member_12.x + _e9428), (_e9196.member_12.y + _e9429), (_e9196.member_12.z + _e9430)), _e9196.member_13, _e9196.member_14, _e9196.member_15, _e9196.member_16, _e9196.member_17);
}
let _e9566 = phi_13171_;
phi_13172_ = _e9566;
} else {
phi_13172_ = _e9196;
}
let _e9568 = phi_13172_;
let _e9570 = (_e9568.member_8 + 1f);
let _e9588 = type_25(_e9568.member, _e9568.member_1, _e9568.member_2, _e9568.member_3, _e9568.member_4, _e9568.member_5, _e9568.member_6, _e9568.member_7, _e9570, _e9568.member_9, _e9568.member_10, _e9568.member_11, _e9568.member_12, _e9568.member_13, _e9568.member_14, _e9568.member_15, _e9568.member_16, _e9568.member_17);
let _e9592 = !(_e9212);
let _e9593 = (((_e125.member_2 == 0u) && (_e9570 >= 2f)) && _e9592);
if (_e9081 && _e9593) {
let _e9656 = (((_e9568.member_1.x * _e8692.member.x) + (_e9568.member_1.y * _e8692.member.y)) + (_e9568.member_1.z * _e8692.member.z));
let _e9660 = (_e9568.member_1.x - (_e8692.member.x * _e9656));
let _e9661 = (_e9568.member_1.y - (_e8692.member.y * _e9656));
let _e9662 = (_e9568.member_1.z - (_e8692.member.z * _e9656));
let _e9667 = (((_e9660 * _e9660) + (_e9661 * _e9661)) + (_e9662 * _e9662));
let _e9670 = sqrt(select(0f, _e9667, (_e9667 > 0f)));
let _e9673 = (1f / select(1e-20f, _e9670, (_e9670 > 1e-20f)));
phi_13259_ = type_25(_e9588.member, vec3<f32>((_e9660 * _e9673), (_e9661 * _e9673), (_e9662 * _e9673)), _e9588.member_2, _e9588.member_3, _e9588.member_4, _e9588.member_5, _e9588.member_6, _e9588.member_7, _e9588.member_8, _e9588.member_9, _e9588.member_10, _e9588.member_11, _e9588.member_12, _e9588.member_13, _e9588.member_14, _e9588.member_15, _e9588.member_16, _e9588.member_17);
} else {
if _e9212 {
let _e9617 = (((_e9100 * _e9100) + (_e9101 * _e9101)) + (_e9102 * _e9102));
let _e9620 = sqrt(select(0f, _e9617, (_e9617 > 0f)));
let _e9623 = (1f / select(1e-20f, _e9620, (_e9620 > 1e-20f)));
phi_13258_ = type_25(_e9588.member, vec3<f32>((_e9100 * _e9623), (_e9101 * _e9623), (_e9102 * _e9623)), _e9588.member_2, _e9588.member_3, _e9588.member_4, _e9588.member_5, _e9588.member_6, _e9588.member_7, _e9588.member_8, _e9588.member_9, _e9588.member_10, _e9588.member_11, _e9588.member_12, _e9588.member_13, _e9588.member_14, _e9588.member_15, _e9588.member_16, _e9588.member_17);
} else {
phi_13258_ = type_25(_e9588.member, vec3<f32>((_e9103 * _e9116), (_e9104 * _e9116), (_e9105 * _e9116)), _e9588.member_2, _e9588.member_3, _e9588.member_4, _e9588.member_5, _e9588.member_6, _e9588.member_7, _e9588.member_8, _e9588.member_9, _e9588.member_10, _e9588.member_11, _e9588.member_12, _e9588.member_13, _e9588.member_14, _e9588.member_15, _e9588.member_16, _e9588.member_17);
}
let _e9647 = phi_13258_;
phi_13259_ = _e9647;
}
let _e9697 = phi_13259_;
if _e9081 {
phi_13277_ = _e9697;
} else {
let _e9699 = select((1f - _e9156), _e9156, _e9212);
phi_13277_ = type_25(_e9697.member, _e9697.member_1, vec3<f32>((_e9697.member_2.x * _e9699), (_e9697.member_2.y * _e9699), (_e9697.member_2.z * _e9699)), _e9697.member_3, _e9697.member_4, _e9697.member_5, _e9697.member_6, _e9697.member_7, _e9697.member_8, _e9697.member_9, _e9697.member_10, _e9697.member_11, _e9697.member_12, _e9697.member_13, _e9697.member_14, _e9697.member_15, _e9697.member_16, _e9697.member_17);
}
let _e9729 = phi_13277_;
let _e9747 = type_25(_e9729.member, _e9729.member_1, _e9729.member_2, _e9729.member_3, _e9729.member_4, 0f, _e9729.member_6, _e9729.member_7, _e9729.member_8, _e9729.member_9, _e9729.member_10, _e9729.member_11, _e9729.member_12, _e9729.member_13, _e9729.member_14, _e9729.member_15, _e9729.member_16, _e9729.member_17);
let _e9754 = global_1.member.member_18.member.member;
let _e9768 = ((((_e9754.member.member * _e9729.member.x) + (_e9754.member.member_1 * _e9729.member.y)) + (_e9754.member.member_2 * _e9729.member.z)) + _e9754.member_1);
let _e9777 = -((((_e9754.member.member * _e9729.member_1.x) + (_e9754.member.member_1 * _e9729.member_1.y)) + (_e9754.member.member_2 * _e9729.member_1.z)));
let _e9779 = (_e9777 > 1e-9f);
let _e9783 = ((_e9768 / select(1e-9f, _e9777, _e9779)) - 0.015625f);
let _e9786 = select(1e30f, select(0f, _e9783, (_e9783 > 0f)), ((_e9768 > 0f) && _e9779));
let _e9791 = global_1.member.member_18.member_1.member;
let _e9802 = ((((_e9791.member.member * _e9729.member.x) + (_e9791.member.member_1 * _e9729.member.y)) + (_e9791.member.member_2 * _e9729.member.z)) + _e9791.member_1);
let _e9808 = -((((_e9791.member.member * _e9729.member_1.x) + (_e9791.member.member_1 * _e9729.member_1.y)) + (_e9791.member.member_2 * _e9729.member_1.z)));
let _e9810 = (_e9808 > 1e-9f);
let _e9814 = ((_e9802 / select(1e-9f, _e9808, _e9810)) - 0.015625f);
let _e9817 = select(1e30f, select(0f, _e9814, (_e9814 > 0f)), ((_e9802 > 0f) && _e9810));
let _e9821 = (_e9817 < _e9786);
let _e9823 = select(select(-2i, -3i, _e9821), -1i, ((_e9786 >= 1e30f) && (_e9817 >= 1e30f)));
let _e9824 = select(_e9786, _e9817, _e9821);
let _e9842 = type_25(_e9747.member, _e9747.member_1, _e9747.member_2, _e9747.member_3, _e9747.member_4, _e9747.member_5, _e9747.member_6, _e9747.member_7, _e9747.member_8, _e9747.member_9, _e9747.member_10, _e9747.member_11, _e9747.member_12, _e9747.member_13, _e9747.member_14, 0i, _e9747.member_16, _e9747.member_17);
let _e9860 = type_25(_e9842.member, _e9842.member_1, _e9842.member_2, _e9842.member_3, _e9842.member_4, _e9842.member_5, _e9842.member_6, _e9842.member_7, _e9842.member_8, _e9842.member_9, _e9842.member_10, _e9842.member_11, _e9842.member_12, _e9842.member_13, _e9842.member_14, _e9842.member_15, _e9823, _e9842.member_17);
let _e9878 = type_25(_e9860.member, _e9860.member_1, _e9860.member_2, _e9860.member_3, _e9860.member_4, _e9860.member_5, _e9860.member_6, _e9860.member_7, _e9860.member_8, _e9860.member_9, _e9860.member_10, _e9860.member_11, _e9860.member_12, _e9860.member_13, _e9860.member_14, _e9860.member_15, _e9860.member_16, _e9824);
let _e9879 = (_e9081 || _e9212);
let _e9881 = local_19;
let _e9884 = ((_e9153 & 2u) != 0u);
if (_e9593 && !(_e9884)) {
if (_e9823 == -1i) {
phi_13704_ = type_25(_e9878.member, _e9878.member_1, _e9878.member_2, _e9878.member_3, _e9878.member_4, _e9878.member_5, 1f, _e9878.member_7, _e9878.member_8, _e9878.member_9, _e9878.member_10, _e9878.member_11, _e9878.member_12, _e9878.member_13, _e9878.member_14, _e9878.member_15, _e9878.member_16, _e9878.member_17);
} else {
let _e9970 = type_25(vec3<f32>((_e9729.member.x + (_e9729.member_1.x * _e9824)), (_e9729.member.y + (_e9729.member_1.y * _e9824)), (_e9729.member.z + (_e9729.member_1.z * _e9824))), _e9878.member_1, _e9878.member_2, _e9878.member_3, _e9878.member_4, _e9878.member_5, _e9878.member_6, _e9878.member_7, _e9878.member_8, _e9878.member_9, _e9878.member_10, _e9878.member_11, _e9878.member_12, _e9878.member_13, _e9878.member_14, _e9878.member_15, _e9878.member_16, _e9878.member_17);
let _e9989 = type_25(_e9970.member, _e9970.member_1, _e9970.member_2, _e9970.member_3, _e9970.member_4, (0f + _e9824), _e9970.member_6, _e9970.member_7, _e9970.member_8, _e9970.member_9, _e9970.member_10, _e9970.member_11, _e9970.member_12, _e9970.member_13, _e9970.member_14, _e9970.member_15, _e9970.member_16, _e9970.member_17);
let _e10008 = type_25(_e9989.member, _e9989.member_1, _e9989.member_2, _e9989.member_3, _e9989.member_4, _e9989.member_5, _e9989.member_6, _e9989.member_7, _e9989.member_8, _e9989.member_9, _e9989.member_10, _e9989.member_11, _e9989.member_12, _e9989.member_13, _e9989.member_14, _e9989.member_15, _e9989.member_16, (_e9824 - _e9824));
let _e10031 = type_25(_e10008.member, _e10008.member_1, _e10008.member_2, _e10008.member_3, _e10008.member_4, _e10008.member_5, _e10008.member_6, _e10008.member_7, _e10008.member_8, _e10008.member_9, (_e9729.member_10 + select(0f, _e9824, (_e9729.member_8 == 0f))), _e10008.member_11, _e10008.member_12, _e10008.member_13, _e10008.member_14, _e10008.member_15, _e10008.member_16, _e10008.member_17);
phi_13704_ = type_25(_e10031.member, _e10031.member_1, _e10031.member_2, _e10031.member_3, _e10031.member_4, _e10031.member_5, 3f, _e10031.member_7, _e10031.member_8, _e10031.member_9, _e10031.member_10, _e10031.member_11, _e10031.member_12, _e10031.member_13, _e10031.member_14, _e10031.member_15, _e10031.member_16, _e10031.member_17);
}
let _e10069 = phi_13704_;
phi_13727_ = _e10069;
} else {
let _e9892 = global_1.member.member_5;
if (((!(_e9593) && _e9592) && (_e9729.member_8 >= f32(bitcast<i32>(_e9892)))) && (select(_e9881, _e919.member_7, _e9879) != 16i)) {
phi_13726_ = type_25(_e9878.member, _e9878.member_1, _e9878.member_2, _e9878.member_3, _e9878.member_4, _e9878.member_5, 2f, _e9878.member_7, _e9878.member_8, _e9878.member_9, _e9878.member_10, _e9878.member_11, _e9878.member_12, _e9878.member_13, _e9878.member_14, _e9878.member_15, _e9878.member_16, _e9878.member_17);
} else {
if _e9884 {
phi_13725_ = type_25(_e9878.member, _e9878.member_1, _e9878.member_2, _e9878.member_3, _e9878.member_4, _e9878.member_5, 4f, _e9878.member_7, _e9878.member_8, _e9878.member_9, _e9878.member_10, _e9878.member_11, _e9878.member_12, _e9878.member_13, _e9878.member_14, _e9878.member_15, _e9878.member_16, _e9878.member_17);
} else {
phi_13725_ = _e9878;
}
let _e9918 = phi_13725_;
phi_13726_ = _e9918;
}
let _e9938 = phi_13726_;
phi_13727_ = _e9938;
}
let _e10071 = phi_13727_;
let _e10074 = local_20;
let _e10093 = type_25(_e10071.member, _e10071.member_1, _e10071.member_2, _e10071.member_3, _e10071.member_4, _e10071.member_5, _e10071.member_6, select(_e919.member_7, _e10074, !(_e9879)), _e10071.member_8, _e10071.member_9, _e10071.member_10, _e10071.member_11, _e10071.member_12, _e10071.member_13, _e10071.member_14, _e10071.member_15, _e10071.member_16, _e10071.member_17);
phi_13735_ = type_25(_e10093.member, _e10093.member_1, _e10093.member_2, _e10093.member_3, _e8692.member, _e10093.member_5, _e10093.member_6, _e10093.member_7, _e10093.member_8, _e10093.member_9, _e10093.member_10, _e10093.member_11, _e10093.member_12, _e10093.member_13, _e10093.member_14, _e10093.member_15, _e10093.member_16, _e10093.member_17);
}
let _e10113 = phi_13735_;
phi_13736_ = _e10113;
phi_13737_ = _e8722;
}
let _e10115 = phi_13736_;
let _e10117 = phi_13737_;
if (_e10117 && _e1129) {
let _e10626 = type_25(vec3<f32>((_e10115.member.x + (_e10115.member_1.x * _e10115.member_17)), (_e10115.member.y + (_e10115.member_1.y * _e10115.member_17)), (_e10115.member.z + (_e10115.member_1.z * _e10115.member_17))), _e10115.member_1, _e10115.member_2, _e10115.member_3, _e10115.member_4, _e10115.member_5, _e10115.member_6, _e10115.member_7, _e10115.member_8, _e10115.member_9, _e10115.member_10, _e10115.member_11, _e10115.member_12, _e10115.member_13, _e10115.member_14, _e10115.member_15, _e10115.member_16, _e10115.member_17);
let _e10646 = type_25(_e10626.member, _e10626.member_1, _e10626.member_2, _e10626.member_3, _e10626.member_4, (_e10115.member_5 + _e10115.member_17), _e10626.member_6, _e10626.member_7, _e10626.member_8, _e10626.member_9, _e10626.member_10, _e10626.member_11, _e10626.member_12, _e10626.member_13, _e10626.member_14, _e10626.member_15, _e10626.member_16, _e10626.member_17);
let _e10665 = type_25(_e10646.member, _e10646.member_1, _e10646.member_2, _e10646.member_3, _e10646.member_4, _e10646.member_5, _e10646.member_6, _e10646.member_7, _e10646.member_8, _e10646.member_9, _e10646.member_10, _e10646.member_11, _e10646.member_12, _e10646.member_13, _e10646.member_14, _e10646.member_15, _e10646.member_16, (_e10115.member_17 - _e10115.member_17));
let _e10688 = type_25(_e10665.member, _e10665.member_1, _e10665.member_2, _e10665.member_3, _e10665.member_4, _e10665.member_5, _e10665.member_6, _e10665.member_7, _e10665.member_8, _e10665.member_9, (_e10115.member_10 + select(0f, _e10115.member_17, (_e10115.member_8 == 0f))), _e10665.member_11, _e10665.member_12, _e10665.member_13, _e10665.member_14, _e10665.member_15, _e10665.member_16, _e10665.member_17);
if (_e919.member_7 != 16i) {
let _e10709 = type_25(_e10688.member, _e10688.member_1, _e10688.member_2, _e10688.member_3, _e10688.member_4, _e10688.member_5, _e10688.member_6, _e10688.member_7, _e10688.member_8, (_e10115.member_9 + _e10115.member_17), _e10688.member_10, _e10688.member_11, _e10688.member_12, _e10688.member_13, _e10688.member_14, _e10688.member_15, _e10688.member_16, _e10688.member_17);
let _e10710 = (_e919.member_7 * 4i);
let _e10711 = (_e10710 + 1i);
let _e10713 = (bitcast<i32>(_e118) - 1i);
let _e10715 = select(_e10713, _e10711, (_e10711 < _e10713));
let _e10721 = global_2.member[bitcast<u32>(select(0i, _e10715, (_e10715 > 0i)))];
let _e10723 = -((_e10721 * _e10115.member_17));
let _e10725 = select(-87f, _e10723, (_e10723 > -87f));
let _e10727 = select(88f, _e10725, (_e10725 < 88f));
let _e10729 = ((_e10727 * 1.442695f) + 0.5f);
let _e10731 = select(-127f, _e10729, (_e10729 > -127f));
let _e10733 = select(128f, _e10731, (_e10731 < 128f));
let _e10740 = select(0i, select(select(i32(_e10733), i32(-2147483648), (_e10733 < -2147483600f)), 2147483647i, (_e10733 > 2147483500f)), (_e10733 == _e10733));
let _e10744 = (_e10740 - select(0i, 1i, (_e10733 < f32(_e10740))));
let _e10745 = f32(_e10744);
let _e10749 = ((_e10727 - (_e10745 * 0.6933594f)) - (_e10745 * -2.1219444e-4f));
let _e10770 = (_e10710 + 2i);
let _e10772 = select(_e10713, _e10770, (_e10770 < _e10713));
let _e10778 = global_2.member[bitcast<u32>(select(0i, _e10772, (_e10772 > 0i)))];
let _e10780 = -((_e10778 * _e10115.member_17));
let _e10782 = select(-87f, _e10780, (_e10780 > -87f));
let _e10784 = select(88f, _e10782, (_e10782 < 88f));
let _e10786 = ((_e10784 * 1.442695f) + 0.5f);
let _e10788 = select(-127f, _e10786, (_e10786 > -127f));
let _e10790 = select(128f, _e10788, (_e10788 < 128f));
let _e10797 = select(0i, select(select(i32(_e10790), i32(-2147483648), (_e10790 < -2147483600f)), 2147483647i, (_e10790 > 2147483500f)), (_e10790 == _e10790));
let _e10801 = (_e10797 - select(0i, 1i, (_e10790 < f32(_e10797))));
let _e10802 = f32(_e10801);
let _e10806 = ((_e10784 - (_e10802 * 0.6933594f)) - (_e10802 * -2.1219444e-4f));
let _e10827 = (_e10710 + 3i);
let _e10829 = select(_e10713, _e10827, (_e10827 < _e10713));
let _e10835 = global_2.member[bitcast<u32>(select(0i, _e10829, (_e10829 > 0i)))];
let _e10837 = -((_e10835 * _e10115.member_17));
let _e10839 = select(-87f, _e10837, (_e10837 > -87f));
let _e10841 = select(88f, _e10839, (_e10839 < 88f));
let _e10843 = ((_e10841 * 1.442695f) + 0.5f);
let _e10845 = select(-127f, _e10843, (_e10843 > -127f));
let _e10847 = select(128f, _e10845, (_e10845 < 128f));
let _e10854 = select(0i, select(select(i32(_e10847), i32(-2147483648), (_e10847 < -2147483600f)), 2147483647i, (_e10847 > 2147483500f)), (_e10847 == _e10847));
let _e10858 = (_e10854 - select(0i, 1i, (_e10847 < f32(_e10854))));
let _e10859 = f32(_e10858);
let _e10863 = ((_e10841 - (_e10859 * 0.6933594f)) - (_e10859 * -2.1219444e-4f));
phi_14027_ = type_25(_e10709.member, _e10709.member_1, vec3<f32>((_e10115.member_2.x * ((1f + (_e10749 * (1f + (_e10749 * (0.5f + (_e10749 * (0.16666667f + (_e10749 * (0.041666668f + (_e10749 * (0.008333334f + (_e10749 * (0.001388889f + (_e10749 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e10744 + 127i)) << bitcast<u32>(23i))))), (_e10115.member_2.y * ((1f + (_e10806 * (1f + (_e10806 * (0.5f + (_e10806 * (0.16666667f + (_e10806 * (0.041666668f + (_e10806 * (0.008333334f + (_e10806 * (0.001388889f + (_e10806 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e10801 + 127i)) << bitcast<u32>(23i))))), (_e10115.member_2.z * ((1f + (_e10863 * (1f + (_e10863 * (0.5f + (_e10863 * (0.16666667f + (_e10863 * (0.041666668f + (_e10863 * (0.008333334f + (_e10863 * (0.001388889f + (_e10863 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e10858 + 127i)) << bitcast<u32>(23i)))))), _e10709.member_3, _e10709.member_4, _e10709.member_5, _e10709.member_6, _e10709.member_7, _e10709.member_8, _e10709.member_9, _e10709.member_10, _e10709.member_11, _e10709.member_12, _e10709.member_13, _e10709.member_14, _e10709.member_15, _e10709.member_16, _e10709.member_17);
} else {
phi_14027_ = _e10688;
}
let _e10913 = phi_14027_;
phi_14621_ = type_25(_e10913.member, _e10913.member_1, _e10913.member_2, _e10913.member_3, _e10913.member_4, _e10913.member_5, 3f, _e10913.member_7, _e10913.member_8, _e10913.member_9, _e10913.member_10, _e10913.member_11, _e10913.member_12, _e10913.member_13, _e10913.member_14, _e10913.member_15, _e10913.member_16, _e10913.member_17);
} else {
if _e10117 {
let _e10153 = type_25(vec3<f32>((_e10115.member.x + (_e10115.member_1.x * _e1130)), (_e10115.member.y + (_e10115.member_1.y * _e1130)), (_e10115.member.z + (_e10115.member_1.z * _e1130))), _e10115.member_1, _e10115.member_2, _e10115.member_3, _e10115.member_4, _e10115.member_5, _e10115.member_6, _e10115.member_7, _e10115.member_8, _e10115.member_9, _e10115.member_10, _e10115.member_11, _e10115.member_12, _e10115.member_13, _e10115.member_14, _e10115.member_15, _e10115.member_16, _e10115.member_17);
let _e10173 = type_25(_e10153.member, _e10153.member_1, _e10153.member_2, _e10153.member_3, _e10153.member_4, (_e10115.member_5 + _e1130), _e10153.member_6, _e10153.member_7, _e10153.member_8, _e10153.member_9, _e10153.member_10, _e10153.member_11, _e10153.member_12, _e10153.member_13, _e10153.member_14, _e10153.member_15, _e10153.member_16, _e10153.member_17);
let _e10193 = type_25(_e10173.member, _e10173.member_1, _e10173.member_2, _e10173.member_3, _e10173.member_4, _e10173.member_5, _e10173.member_6, _e10173.member_7, _e10173.member_8, _e10173.member_9, _e10173.member_10, _e10173.member_11, _e10173.member_12, _e10173.member_13, _e10173.member_14, _e10173.member_15, _e10173.member_16, (_e10115.member_17 - _e1130));
let _e10216 = type_25(_e10193.member, _e10193.member_1, _e10193.member_2, _e10193.member_3, _e10193.member_4, _e10193.member_5, _e10193.member_6, _e10193.member_7, _e10193.member_8, _e10193.member_9, (_e10115.member_10 + select(0f, _e1130, (_e10115.member_8 == 0f))), _e10193.member_11, _e10193.member_12, _e10193.member_13, _e10193.member_14, _e10193.member_15, _e10193.member_16, _e10193.member_17);
if (_e919.member_7 != 16i) {
let _e10237 = type_25(_e10216.member, _e10216.member_1, _e10216.member_2, _e10216.member_3, _e10216.member_4, _e10216.member_5, _e10216.member_6, _e10216.member_7, _e10216.member_8, (_e10115.member_9 + _e1130), _e10216.member_10, _e10216.member_11, _e10216.member_12, _e10216.member_13, _e10216.member_14, _e10216.member_15, _e10216.member_16, _e10216.member_17);
let _e10238 = (_e919.member_7 * 4i);
let _e10239 = (_e10238 + 1i);
let _e10241 = (bitcast<i32>(_e118) - 1i);
let _e10243 = select(_e10241, _e10239, (_e10239 < _e10241));
let _e10249 = global_2.member[bitcast<u32>(select(0i, _e10243, (_e10243 > 0i)))];
let _e10251 = -((_e10249 * _e1130));
let _e10253 = select(-87f, _e10251, (_e10251 > -87f));
let _e10255 = select(88f, _e10253, (_e10253 < 88f));
let _e10257 = ((_e10255 * 1.442695f) + 0.5f);
let _e10259 = select(-127f, _e10257, (_e10257 > -127f));
let _e10261 = select(128f, _e10259, (_e10259 < 128f));
let _e10268 = select(0i, select(select(i32(_e10261), i32(-2147483648), (_e10261 < -2147483600f)), 2147483647i, (_e10261 > 2147483500f)), (_e10261 == _e10261));
let _e10272 = (_e10268 - select(0i, 1i, (_e10261 < f32(_e10268))));
let _e10273 = f32(_e10272);
let _e10277 = ((_e10255 - (_e10273 * 0.6933594f)) - (_e10273 * -2.1219444e-4f));
let _e10298 = (_e10238 + 2i);
let _e10300 = select(_e10241, _e10298, (_e10298 < _e10241));
let _e10306 = global_2.member[bitcast<u32>(select(0i, _e10300, (_e10300 > 0i)))];
let _e10308 = -((_e10306 * _e1130));
let _e10310 = select(-87f, _e10308, (_e10308 > -87f));
let _e10312 = select(88f, _e10310, (_e10310 < 88f));
let _e10314 = ((_e10312 * 1.442695f) + 0.5f);
let _e10316 = select(-127f, _e10314, (_e10314 > -127f));
let _e10318 = select(128f, _e10316, (_e10316 < 128f));
let _e10325 = select(0i, select(select(i32(_e10318), i32(-2147483648), (_e10318 < -2147483600f)), 2147483647i, (_e10318 > 2147483500f)), (_e10318 == _e10318));
let _e10329 = (_e10325 - select(0i, 1i, (_e10318 < f32(_e10325))));
let _e10330 = f32(_e10329);
let _e10334 = ((_e10312 - (_e10330 * 0.6933594f)) - (_e10330 * -2.1219444e-4f));
let _e10355 = (_e10238 + 3i);
let _e10357 = select(_e10241, _e10355, (_e10355 < _e10241));
let _e10363 = global_2.member[bitcast<u32>(select(0i, _e10357, (_e10357 > 0i)))];
let _e10365 = -((_e10363 * _e1130));
let _e10367 = select(-87f, _e10365, (_e10365 > -87f));
let _e10369 = select(88f, _e10367, (_e10367 < 88f));
let _e10371 = ((_e10369 * 1.442695f) + 0.5f);
let _e10373 = select(-127f, _e10371, (_e10371 > -127f));
let _e10375 = select(128f, _e10373, (_e10373 < 128f));
let _e10382 = select(0i, select(select(i32(_e10375), i32(-2147483648), (_e10375 < -2147483600f)), 2147483647i, (_e10375 > 2147483500f)), (_e10375 == _e10375));
let _e10386 = (_e10382 - select(0i, 1i, (_e10375 < f32(_e10382))));
let _e10387 = f32(_e10386);
let _e10391 = ((_e10369 - (_e10387 * 0.6933594f)) - (_e10387 * -2.1219444e-4f));
phi_14316_ = type_25(_e10237.member, _e10237.member_1, vec3<f32>((_e10115.member_2.x * ((1f + (_e10277 * (1f + (_e10277 * (0.5f + (_e10277 * (0.16666667f + (_e10277 * (0.041666668f + (_e10277 * (0.008333334f + (_e10277 * (0.001388889f + (_e10277 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e10272 + 127i)) << bitcast<u32>(23i))))), (_e10115.member_2.y * ((1f + (_e10334 * (1f + (_e10334 * (0.5f + (_e10334 * (0.16666667f + (_e10334 * (0.041666668f + (_e10334 * (0.008333334f + (_e10334 * (0.001388889f + (_e10334 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e10329 + 127i)) << bitcast<u32>(23i))))), (_e10115.member_2.z * ((1f + (_e10391 * (1f + (_e10391 * (0.5f + (_e10391 * (0.16666667f + (_e10391 * (0.041666668f + (_e10391 * (0.008333334f + (_e10391 * (0.001388889f + (_e10391 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e10386 + 127i)) << bitcast<u32>(23i)))))), _e10237.member_3, _e10237.member_4, _e10237.member_5, _e10237.member_6, _e10237.member_7, _e10237.member_8, _e10237.member_9, _e10237.member_10, _e10237.member_11, _e10237.member_12, _e10237.member_13, _e10237.member_14, _e10237.member_15, _e10237.member_16, _e10237.member_17);
} else {
phi_14316_ = _e10216;
}
let _e10441 = phi_14316_;
let _e10444 = local_21;
if (((_e980 <= 0f) && (_e10444 == 16i)) && (_e919.member_7 == 16i)) {
if (_e10441.member_16 == -1i) {
phi_14618_ = type_25(_e10441.member, _e10441.member_1, _e10441.member_2, _e10441.member_3, _e10441.member_4, _e10441.member_5, 1f, _e10441.member_7, _e10441.member_8, _e10441.member_9, _e10441.member_10, _e10441.member_11, _e10441.member_12, _e10441.member_13, _e10441.member_14, _e10441.member_15, _e10441.member_16, _e10441.member_17);
} else {
let _e10486 = type_25(vec3<f32>((_e10441.member.x + (_e10441.member_1.x * _e10441.member_17)), (_e10441.member.y + (_e10441.member_1.y * _e10441.member_17)), (_e10441.member.z + (_e10441.member_1.z * _e10441.member_17))), _e10441.member_1, _e10441.member_2, _e10441.member_3, _e10441.member_4, _e10441.member_5, _e10441.member_6, _e10441.member_7, _e10441.member_8, _e10441.member_9, _e10441.member_10, _e10441.member_11, _e10441.member_12, _e10441.member_13, _e10441.member_14, _e10441.member_15, _e10441.member_16, _e10441.member_17);
let _e10506 = type_25(_e10486.member, _e10486.member_1, _e10486.member_2, _e10486.member_3, _e10486.member_4, (_e10441.member_5 + _e10441.member_17), _e10486.member_6, _e10486.member_7, _e10486.member_8, _e10486.member_9, _e10486.member_10, _e10486.member_11, _e10486.member_12, _e10486.member_13, _e10486.member_14, _e10486.member_15, _e10486.member_16, _e10486.member_17);
let _e10525 = type_25(_e10506.member, _e10506.member_1, _e10506.member_2, _e10506.member_3, _e10506.member_4, _e10506.member_5, _e10506.member_6, _e10506.member_7, _e10506.member_8, _e10506.member_9, _e10506.member_10, _e10506.member_11, _e10506.member_12, _e10506.member_13, _e10506.member_14, _e10506.member_15, _e10506.member_16, (_e10441.member_17 - _e10441.member_17));
let _e10548 = type_25(_e10525.member, _e10525.member_1, _e10525.member_2, _e10525.member_3, _e10525.member_4, _e10525.member_5, _e10525.member_6, _e10525.member_7, _e10525.member_8, _e10525.member_9, (_e10441.member_10 + select(0f, _e10441.member_17, (_e10441.member_8 == 0f))), _e10525.member_11, _e10525.member_12, _e10525.member_13, _e10525.member_14, _e10525.member_15, _e10525.member_16, _e10525.member_17);
phi_14618_ = type_25(_e10548.member, _e10548.member_1, _e10548.member_2, _e10548.member_3, _e10548.member_4, _e10548.member_5, 3f, _e10548.member_7, _e10548.member_8, _e10548.member_9, _e10548.member_10, _e10548.member_11, _e10548.member_12, _e10548.member_13, _e10548.member_14, _e10548.member_15, _e10548.member_16, _e10548.member_17);
}
let _e10586 = phi_14618_;
phi_14619_ = _e10586;
} else {
phi_14619_ = _e10441;
}
let _e10588 = phi_14619_;
phi_14620_ = _e10588;
} else {
phi_14620_ = _e10115;
}
let _e10590 = phi_14620_;
phi_14621_ = _e10590;
}
let _e10933 = phi_14621_;
phi_1353_ = _e10933;
phi_1356_ = (_e921 + 1i);
} else {
phi_1353_ = type_25();
phi_1356_ = i32();
}
let _e10935 = phi_1353_;
let _e10937 = phi_1356_;
continue;
continuing {
phi_1352_ = _e10935;
phi_1355_ = _e10937;
break if !(_e925);
}
}
let _e10940 = local_22;
let _e10944 = local_23;
let _e10948 = local_24;
let _e10952 = local_25;
let _e10956 = local_26;
let _e10960 = local_27;
let _e10964 = local_28;
let _e10968 = local_29;
let _e10972 = local_30;
let _e10976 = local_31;
let _e10980 = local_32;
let _e10984 = local_33;
let _e10988 = local_34;
let _e10992 = local_35;
let _e10996 = local_36;
let _e11000 = local_37;
let _e11003 = local_38;
let _e11007 = local_39;
let _e11010 = local_40;
let _e11013 = local_41;
let _e11016 = local_42;
let _e11019 = local_43;
let _e11023 = local_44;
let _e11027 = local_45;
let _e11031 = local_46;
let _e11035 = local_47;
let _e11039 = local_48;
let _e11043 = local_49;
let _e11047 = local_50;
let _e11051 = local_51;
let _e11055 = local_52;
global_3.member[_e134] = _e10940.member.x;
global_3.member[_e146] = _e10944.member.y;
global_3.member[_e157] = _e10948.member.z;
global_3.member[_e168] = _e10952.member_1.x;
global_3.member[_e179] = _e10956.member_1.y;
global_3.member[_e190] = _e10960.member_1.z;
global_3.member[_e201] = _e10964.member_2.x;
global_3.member[_e212] = _e10968.member_2.y;
global_3.member[_e223] = _e10972.member_2.z;
global_3.member[_e234] = _e10976.member_3.x;
global_3.member[_e245] = _e10980.member_3.y;
global_3.member[_e256] = _e10984.member_3.z;
global_3.member[_e267] = _e10988.member_4.x;
global_3.member[_e278] = _e10992.member_4.y;
global_3.member[_e289] = _e10996.member_4.z;
global_3.member[_e300] = _e11000.member_5;
let _e11092 = local_53;
global_3.member[_e311] = _e11092;
global_3.member[_e322] = f32(_e11003.member_7);
global_3.member[_e333] = _e11007.member_8;
global_3.member[_e344] = _e11010.member_9;
global_3.member[_e355] = _e11013.member_10;
global_3.member[_e366] = _e11016.member_11;
global_3.member[_e377] = _e11019.member_12.x;
global_3.member[_e388] = _e11023.member_12.y;
global_3.member[_e399] = _e11027.member_12.z;
global_3.member[_e410] = _e11031.member_13.x;
global_3.member[_e421] = _e11035.member_13.y;
global_3.member[_e432] = _e11039.member_13.z;
global_3.member[_e443] = f32(_e11043.member_14);
global_3.member[_e454] = f32(_e11047.member_15);
global_3.member[_e465] = f32(_e11051.member_16);
global_3.member[_e476] = _e11055.member_17;
}
}
}
return;
}
@compute @workgroup_size(8, 8, 1)
fn main(@builtin(global_invocation_id) param: vec3<u32>) {
global = param;
function_();
}
