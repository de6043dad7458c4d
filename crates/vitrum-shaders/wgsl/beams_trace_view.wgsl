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
struct type_13 {
member: array<f32>,
}
struct type_17 {
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
struct type_18 {
member: u32,
member_1: u32,
}
struct type_19 {
member: u32,
member_1: type_5,
member_2: type_5,
member_3: type_5,
member_4: type_5,
member_5: f32,
member_6: f32,
member_7: f32,
member_8: f32,
}
struct type_20 {
member: f32,
member_1: f32,
member_2: f32,
member_3: u32,
member_4: u32,
member_5: u32,
member_6: u32,
member_7: u32,
}
struct type_21 {
member: type_5,
member_1: type_5,
member_2: f32,
member_3: u32,
member_4: type_5,
member_5: type_5,
}
struct type_22 {
member: f32,
member_1: u32,
member_2: u32,
member_3: u32,
member_4: u32,
member_5: u32,
member_6: u32,
member_7: u32,
member_8: u32,
member_9: u32,
}
struct type_23 {
member: type_2,
member_1: type_18,
member_2: type_4,
member_3: type_5,
member_4: type_5,
member_5: type_5,
member_6: type_5,
member_7: f32,
member_8: type_5,
member_9: type_5,
member_10: type_11,
member_11: type_19,
member_12: type_20,
member_13: type_21,
member_14: type_9,
member_15: type_6,
member_16: type_5,
member_17: u32,
member_18: type_22,
}
struct type_24 {
member: type_23,
}
struct type_25 {
member: vec3<f32>,
member_1: vec3<f32>,
member_2: vec3<f32>,
member_3: vec3<f32>,
member_4: vec3<f32>,
member_5: vec3<f32>,
member_6: vec3<f32>,
member_7: i32,
member_8: i32,
member_9: i32,
member_10: f32,
member_11: i32,
member_12: i32,
member_13: f32,
member_14: f32,
member_15: f32,
member_16: i32,
member_17: i32,
member_18: i32,
member_19: i32,
member_20: i32,
member_21: i32,
member_22: i32,
member_23: f32,
member_24: f32,
member_25: f32,
member_26: f32,
member_27: f32,
}
struct type_26 {
member: i32,
member_1: i32,
member_2: f32,
member_3: f32,
member_4: f32,
}
struct type_29 {
member: array<atomic<u32>>,
}
var<private> global: vec3<u32>;
@group(0) @binding(1)
var<storage> global_1: type_13;
@group(0) @binding(2)
var<storage> global_2: type_13;
@group(0) @binding(3)
var<storage> global_3: type_13;
@group(0) @binding(4)
var<storage, read_write> global_4: type_13;
@group(0) @binding(0)
var<storage> global_5: type_24;
@group(0) @binding(5)
var<storage, read_write> global_6: type_29;
fn function_() {
var phi_2374_: f32;
var phi_2401_: type_25;
var phi_2402_: type_25;
var phi_2422_: type_25;
var phi_2424_: type_25;
var phi_2427_: i32;
var phi_2429_: bool;
var phi_3770_: i32;
var phi_3773_: i32;
var phi_3771_: i32;
var phi_3774_: i32;
var local: i32;
var phi_3894_: i32;
var phi_3897_: i32;
var phi_3895_: i32;
var phi_3898_: i32;
var local_1: i32;
var phi_4579_: f32;
var phi_4293_: f32;
var phi_4583_: type_25;
var local_2: i32;
var local_3: i32;
var local_4: i32;
var local_5: i32;
var local_6: i32;
var phi_6571_: f32;
var phi_6572_: f32;
var phi_6805_: f32;
var local_7: i32;
var local_8: i32;
var local_9: i32;
var phi_7609_: type_25;
var phi_7619_: type_25;
var phi_7620_: type_25;
var phi_7640_: type_25;
var phi_7795_: vec3<f32>;
var phi_7921_: vec3<f32>;
var phi_7939_: type_25;
var phi_6936_: f32;
var phi_7940_: type_25;
var phi_8095_: f32;
var phi_8139_: type_25;
var phi_9370_: f32;
var phi_9397_: type_25;
var phi_9398_: type_25;
var phi_9399_: type_25;
var phi_9400_: type_25;
var phi_9401_: type_25;
var phi_4637_: f32;
var phi_4649_: type_25;
var phi_4690_: type_25;
var phi_5921_: f32;
var phi_5948_: type_25;
var phi_5949_: type_25;
var phi_9402_: type_25;
var phi_9403_: type_25;
var phi_9404_: bool;
var phi_9408_: type_25;
var phi_9409_: type_25;
var phi_2655_: f32;
var phi_2968_: i32;
var phi_3579_: i32;
var phi_3729_: type_26;
var phi_3723_: bool;
var phi_3724_: bool;
var phi_3730_: type_26;
var phi_3731_: bool;
var phi_3738_: type_17;
var phi_3739_: type_26;
var phi_3740_: type_17;
var phi_3742_: type_26;
var phi_3743_: type_17;
var phi_3744_: bool;
var phi_3748_: type_26;
var phi_3749_: type_17;
var phi_3750_: bool;
var phi_3754_: type_26;
var phi_3755_: type_17;
var phi_9411_: type_25;
var phi_9412_: bool;
var phi_2425_: type_25;
var phi_2428_: i32;
var phi_2430_: bool;
var local_10: type_25;
var local_11: type_25;
var local_12: type_25;
var local_13: type_25;
var local_14: type_25;
var local_15: type_25;
var local_16: type_25;
var local_17: type_25;
var local_18: type_25;
var local_19: type_25;
var local_20: type_25;
var local_21: type_25;
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
var local_51: f32;
let _e121 = global;
let _e123 = arrayLength((&global_1.member));
let _e125 = arrayLength((&global_2.member));
let _e127 = arrayLength((&global_3.member));
let _e134 = global_5.member.member;
if (_e121.x < _e134.member) {
if (_e121.y < _e134.member_1) {
let _e141 = (_e134.member * _e134.member_1);
let _e143 = ((_e121.y * _e134.member) + _e121.x);
let _e144 = bitcast<i32>(_e143);
let _e146 = (bitcast<i32>(arrayLength((&global_4.member))) - 1i);
let _e148 = select(_e146, _e144, (_e144 < _e146));
let _e154 = global_4.member[bitcast<u32>(select(0i, _e148, (_e148 > 0i)))];
let _e155 = (_e141 + _e143);
let _e156 = bitcast<i32>(_e155);
let _e158 = select(_e146, _e156, (_e156 < _e146));
let _e164 = global_4.member[bitcast<u32>(select(0i, _e158, (_e158 > 0i)))];
let _e166 = ((2u * _e141) + _e143);
let _e167 = bitcast<i32>(_e166);
let _e169 = select(_e146, _e167, (_e167 < _e146));
let _e175 = global_4.member[bitcast<u32>(select(0i, _e169, (_e169 > 0i)))];
let _e177 = ((3u * _e141) + _e143);
let _e178 = bitcast<i32>(_e177);
let _e180 = select(_e146, _e178, (_e178 < _e146));
let _e186 = global_4.member[bitcast<u32>(select(0i, _e180, (_e180 > 0i)))];
let _e188 = ((4u * _e141) + _e143);
let _e189 = bitcast<i32>(_e188);
let _e191 = select(_e146, _e189, (_e189 < _e146));
let _e197 = global_4.member[bitcast<u32>(select(0i, _e191, (_e191 > 0i)))];
let _e199 = ((5u * _e141) + _e143);
let _e200 = bitcast<i32>(_e199);
let _e202 = select(_e146, _e200, (_e200 < _e146));
let _e208 = global_4.member[bitcast<u32>(select(0i, _e202, (_e202 > 0i)))];
let _e210 = ((6u * _e141) + _e143);
let _e211 = bitcast<i32>(_e210);
let _e213 = select(_e146, _e211, (_e211 < _e146));
let _e219 = global_4.member[bitcast<u32>(select(0i, _e213, (_e213 > 0i)))];
let _e221 = ((7u * _e141) + _e143);
let _e222 = bitcast<i32>(_e221);
let _e224 = select(_e146, _e222, (_e222 < _e146));
let _e230 = global_4.member[bitcast<u32>(select(0i, _e224, (_e224 > 0i)))];
let _e232 = ((8u * _e141) + _e143);
let _e233 = bitcast<i32>(_e232);
let _e235 = select(_e146, _e233, (_e233 < _e146));
let _e241 = global_4.member[bitcast<u32>(select(0i, _e235, (_e235 > 0i)))];
let _e243 = ((9u * _e141) + _e143);
let _e244 = bitcast<i32>(_e243);
let _e246 = select(_e146, _e244, (_e244 < _e146));
let _e252 = global_4.member[bitcast<u32>(select(0i, _e246, (_e246 > 0i)))];
let _e254 = ((10u * _e141) + _e143);
let _e255 = bitcast<i32>(_e254);
let _e257 = select(_e146, _e255, (_e255 < _e146));
let _e263 = global_4.member[bitcast<u32>(select(0i, _e257, (_e257 > 0i)))];
let _e265 = ((11u * _e141) + _e143);
let _e266 = bitcast<i32>(_e265);
let _e268 = select(_e146, _e266, (_e266 < _e146));
let _e274 = global_4.member[bitcast<u32>(select(0i, _e268, (_e268 > 0i)))];
let _e276 = ((12u * _e141) + _e143);
let _e277 = bitcast<i32>(_e276);
let _e279 = select(_e146, _e277, (_e277 < _e146));
let _e285 = global_4.member[bitcast<u32>(select(0i, _e279, (_e279 > 0i)))];
let _e287 = ((13u * _e141) + _e143);
let _e288 = bitcast<i32>(_e287);
let _e290 = select(_e146, _e288, (_e288 < _e146));
let _e296 = global_4.member[bitcast<u32>(select(0i, _e290, (_e290 > 0i)))];
let _e298 = ((14u * _e141) + _e143);
let _e299 = bitcast<i32>(_e298);
let _e301 = select(_e146, _e299, (_e299 < _e146));
let _e307 = global_4.member[bitcast<u32>(select(0i, _e301, (_e301 > 0i)))];
let _e309 = ((15u * _e141) + _e143);
let _e310 = bitcast<i32>(_e309);
let _e312 = select(_e146, _e310, (_e310 < _e146));
let _e318 = global_4.member[bitcast<u32>(select(0i, _e312, (_e312 > 0i)))];
let _e320 = ((16u * _e141) + _e143);
let _e321 = bitcast<i32>(_e320);
let _e323 = select(_e146, _e321, (_e321 < _e146));
let _e329 = global_4.member[bitcast<u32>(select(0i, _e323, (_e323 > 0i)))];
let _e331 = ((17u * _e141) + _e143);
let _e332 = bitcast<i32>(_e331);
let _e334 = select(_e146, _e332, (_e332 < _e146));
let _e340 = global_4.member[bitcast<u32>(select(0i, _e334, (_e334 > 0i)))];
let _e342 = ((18u * _e141) + _e143);
let _e343 = bitcast<i32>(_e342);
let _e345 = select(_e146, _e343, (_e343 < _e146));
let _e351 = global_4.member[bitcast<u32>(select(0i, _e345, (_e345 > 0i)))];
let _e353 = ((19u * _e141) + _e143);
let _e354 = bitcast<i32>(_e353);
let _e356 = select(_e146, _e354, (_e354 < _e146));
let _e362 = global_4.member[bitcast<u32>(select(0i, _e356, (_e356 > 0i)))];
let _e364 = ((20u * _e141) + _e143);
let _e365 = bitcast<i32>(_e364);
let _e367 = select(_e146, _e365, (_e365 < _e146));
let _e373 = global_4.member[bitcast<u32>(select(0i, _e367, (_e367 > 0i)))];
let _e375 = ((21u * _e141) + _e143);
let _e376 = bitcast<i32>(_e375);
let _e378 = select(_e146, _e376, (_e376 < _e146));
let _e384 = global_4.member[bitcast<u32>(select(0i, _e378, (_e378 > 0i)))];
let _e386 = ((22u * _e141) + _e143);
let _e387 = bitcast<i32>(_e386);
let _e389 = select(_e146, _e387, (_e387 < _e146));
let _e395 = global_4.member[bitcast<u32>(select(0i, _e389, (_e389 > 0i)))];
let _e397 = ((23u * _e141) + _e143);
let _e398 = bitcast<i32>(_e397);
let _e400 = select(_e146, _e398, (_e398 < _e146));
let _e406 = global_4.member[bitcast<u32>(select(0i, _e400, (_e400 > 0i)))];
let _e408 = ((24u * _e141) + _e143);
let _e409 = bitcast<i32>(_e408);
let _e411 = select(_e146, _e409, (_e409 < _e146));
let _e417 = global_4.member[bitcast<u32>(select(0i, _e411, (_e411 > 0i)))];
let _e419 = ((25u * _e141) + _e143);
let _e420 = bitcast<i32>(_e419);
let _e422 = select(_e146, _e420, (_e420 < _e146));
let _e428 = global_4.member[bitcast<u32>(select(0i, _e422, (_e422 > 0i)))];
let _e430 = ((26u * _e141) + _e143);
let _e431 = bitcast<i32>(_e430);
let _e433 = select(_e146, _e431, (_e431 < _e146));
let _e439 = global_4.member[bitcast<u32>(select(0i, _e433, (_e433 > 0i)))];
let _e441 = ((27u * _e141) + _e143);
let _e442 = bitcast<i32>(_e441);
let _e444 = select(_e146, _e442, (_e442 < _e146));
let _e450 = global_4.member[bitcast<u32>(select(0i, _e444, (_e444 > 0i)))];
let _e452 = ((28u * _e141) + _e143);
let _e453 = bitcast<i32>(_e452);
let _e455 = select(_e146, _e453, (_e453 < _e146));
let _e461 = global_4.member[bitcast<u32>(select(0i, _e455, (_e455 > 0i)))];
let _e463 = ((29u * _e141) + _e143);
let _e464 = bitcast<i32>(_e463);
let _e466 = select(_e146, _e464, (_e464 < _e146));
let _e472 = global_4.member[bitcast<u32>(select(0i, _e466, (_e466 > 0i)))];
let _e474 = ((30u * _e141) + _e143);
let _e475 = bitcast<i32>(_e474);
let _e477 = select(_e146, _e475, (_e475 < _e146));
let _e483 = global_4.member[bitcast<u32>(select(0i, _e477, (_e477 > 0i)))];
let _e485 = ((31u * _e141) + _e143);
let _e486 = bitcast<i32>(_e485);
let _e488 = select(_e146, _e486, (_e486 < _e146));
let _e494 = global_4.member[bitcast<u32>(select(0i, _e488, (_e488 > 0i)))];
let _e496 = ((32u * _e141) + _e143);
let _e497 = bitcast<i32>(_e496);
let _e499 = select(_e146, _e497, (_e497 < _e146));
let _e505 = global_4.member[bitcast<u32>(select(0i, _e499, (_e499 > 0i)))];
let _e507 = ((33u * _e141) + _e143);
let _e508 = bitcast<i32>(_e507);
let _e510 = select(_e146, _e508, (_e508 < _e146));
let _e516 = global_4.member[bitcast<u32>(select(0i, _e510, (_e510 > 0i)))];
let _e518 = ((34u * _e141) + _e143);
let _e519 = bitcast<i32>(_e518);
let _e521 = select(_e146, _e519, (_e519 < _e146));
let _e527 = global_4.member[bitcast<u32>(select(0i, _e521, (_e521 > 0i)))];
let _e529 = ((35u * _e141) + _e143);
let _e530 = bitcast<i32>(_e529);
let _e532 = select(_e146, _e530, (_e530 < _e146));
let _e538 = global_4.member[bitcast<u32>(select(0i, _e532, (_e532 > 0i)))];
let _e540 = ((36u * _e141) + _e143);
let _e541 = bitcast<i32>(_e540);
let _e543 = select(_e146, _e541, (_e541 < _e146));
let _e549 = global_4.member[bitcast<u32>(select(0i, _e543, (_e543 > 0i)))];
let _e551 = ((37u * _e141) + _e143);
let _e552 = bitcast<i32>(_e551);
let _e554 = select(_e146, _e552, (_e552 < _e146));
let _e560 = global_4.member[bitcast<u32>(select(0i, _e554, (_e554 > 0i)))];
let _e562 = ((38u * _e141) + _e143);
let _e563 = bitcast<i32>(_e562);
let _e565 = select(_e146, _e563, (_e563 < _e146));
let _e571 = global_4.member[bitcast<u32>(select(0i, _e565, (_e565 > 0i)))];
let _e573 = ((39u * _e141) + _e143);
let _e574 = bitcast<i32>(_e573);
let _e576 = select(_e146, _e574, (_e574 < _e146));
let _e582 = global_4.member[bitcast<u32>(select(0i, _e576, (_e576 > 0i)))];
let _e584 = ((40u * _e141) + _e143);
let _e585 = bitcast<i32>(_e584);
let _e587 = select(_e146, _e585, (_e585 < _e146));
let _e593 = global_4.member[bitcast<u32>(select(0i, _e587, (_e587 > 0i)))];
let _e595 = ((41u * _e141) + _e143);
let _e596 = bitcast<i32>(_e595);
let _e598 = select(_e146, _e596, (_e596 < _e146));
let _e604 = global_4.member[bitcast<u32>(select(0i, _e598, (_e598 > 0i)))];
let _e611 = select(0i, select(select(i32(_e549), i32(-2147483648), (_e549 < -2147483600f)), 2147483647i, (_e549 > 2147483500f)), (_e549 == _e549));
let _e616 = global_5.member.member_12.member_4;
let _e622 = select(3u, 0u, ((_e472 == 3f) || ((_e472 == 2f) && (_e611 > bitcast<i32>(_e616)))));
if (_e622 > 0u) {
if (arrayLength((&global_6.member)) >= 3u) {
let _e631 = atomicLoad((&global_6.member[0u]));
if (_e631 == 0u) {
atomicStore((&global_6.member[0u]), ((_e134.member + 7u) / 8u));
atomicStore((&global_6.member[1u]), ((_e134.member_1 + 7u) / 8u));
atomicStore((&global_6.member[2u]), 1u);
}
}
}
if (_e622 > 1u) {
let _e693 = select(0i, select(select(i32(_e494), i32(-2147483648), (_e494 < -2147483600f)), 2147483647i, (_e494 > 2147483500f)), (_e494 == _e494));
let _e700 = select(0i, select(select(i32(_e505), i32(-2147483648), (_e505 < -2147483600f)), 2147483647i, (_e505 > 2147483500f)), (_e505 == _e505));
let _e707 = select(0i, select(select(i32(_e516), i32(-2147483648), (_e516 < -2147483600f)), 2147483647i, (_e516 > 2147483500f)), (_e516 == _e516));
let _e714 = select(0i, select(select(i32(_e527), i32(-2147483648), (_e527 < -2147483600f)), 2147483647i, (_e527 > 2147483500f)), (_e527 == _e527));
let _e721 = select(0i, select(select(i32(_e538), i32(-2147483648), (_e538 < -2147483600f)), 2147483647i, (_e538 > 2147483500f)), (_e538 == _e538));
if (_e472 == 0f) {
let _e729 = global_5.member.member_1.member;
let _e731 = f32(bitcast<i32>(_e729));
let _e735 = global_5.member.member_1.member_1;
let _e737 = f32(bitcast<i32>(_e735));
let _e747 = global_5.member.member_2.member;
let _e748 = (((((f32(bitcast<i32>(_e121.x)) + 0.5f) / _e731) * 2f) - 1f) * _e747);
let _e756 = global_5.member.member_2.member_1;
let _e757 = ((1f - (((f32(bitcast<i32>(_e121.y)) + 0.5f) / _e737) * 2f)) * _e756);
let _e760 = global_5.member.member_3;
let _e769 = global_5.member.member_4;
let _e776 = ((_e760.member * _e748) + (_e769.member * _e757));
let _e777 = ((_e760.member_1 * _e748) + (_e769.member_1 * _e757));
let _e778 = ((_e760.member_2 * _e748) + (_e769.member_2 * _e757));
let _e782 = global_5.member.member_2.member_3;
let _e783 = (_e782 != 0u);
let _e786 = global_5.member.member_5;
let _e793 = select((_e786.member + _e776), _e786.member, _e783);
let _e794 = select((_e786.member_1 + _e777), _e786.member_1, _e783);
let _e795 = select((_e786.member_2 + _e778), _e786.member_2, _e783);
let _e798 = global_5.member.member_6;
let _e805 = select(_e798.member, (_e798.member + _e776), _e783);
let _e806 = select(_e798.member_1, (_e798.member_1 + _e777), _e783);
let _e807 = select(_e798.member_2, (_e798.member_2 + _e778), _e783);
let _e813 = (((_e793 * _e793) + (_e794 * _e794)) + (_e795 * _e795));
let _e817 = (1f / sqrt(select(0f, _e813, (_e813 > 0f))));
let _e818 = (_e793 * _e817);
let _e819 = (_e794 * _e817);
let _e820 = (_e795 * _e817);
let _e823 = ((2f * _e747) / _e731);
let _e824 = (_e760.member * _e823);
let _e825 = (_e760.member_1 * _e823);
let _e826 = (_e760.member_2 * _e823);
let _e828 = ((-2f * _e756) / _e737);
let _e829 = (_e769.member * _e828);
let _e830 = (_e769.member_1 * _e828);
let _e831 = (_e769.member_2 * _e828);
let _e844 = (((_e824 * _e818) + (_e825 * _e819)) + (_e826 * _e820));
let _e854 = select(((_e824 - (_e818 * _e844)) * _e817), 0f, _e783);
let _e855 = select(((_e825 - (_e819 * _e844)) * _e817), 0f, _e783);
let _e856 = select(((_e826 - (_e820 * _e844)) * _e817), 0f, _e783);
let _e862 = (((_e829 * _e818) + (_e830 * _e819)) + (_e831 * _e820));
let _e872 = select(((_e829 - (_e818 * _e862)) * _e817), 0f, _e783);
let _e873 = select(((_e830 - (_e819 * _e862)) * _e817), 0f, _e783);
let _e874 = select(((_e831 - (_e820 * _e862)) * _e817), 0f, _e783);
let _e883 = (1f / select(_e818, select(1e-12f, -1e-12f, (_e818 < 0f)), (bitcast<f32>((bitcast<u32>(_e818) & 2147483647u)) < 1e-12f)));
let _e891 = (1f / select(_e819, select(1e-12f, -1e-12f, (_e819 < 0f)), (bitcast<f32>((bitcast<u32>(_e819) & 2147483647u)) < 1e-12f)));
let _e899 = (1f / select(_e820, select(1e-12f, -1e-12f, (_e820 < 0f)), (bitcast<f32>((bitcast<u32>(_e820) & 2147483647u)) < 1e-12f)));
let _e902 = global_5.member.member_8;
let _e908 = global_5.member.member_9;
let _e913 = ((_e902.member - _e805) * _e883);
let _e915 = ((_e908.member - _e805) * _e883);
let _e917 = ((_e902.member_1 - _e806) * _e891);
let _e919 = ((_e908.member_1 - _e806) * _e891);
let _e921 = ((_e902.member_2 - _e807) * _e899);
let _e923 = ((_e908.member_2 - _e807) * _e899);
let _e925 = select(_e915, _e913, (_e913 < _e915));
let _e927 = select(_e919, _e917, (_e917 < _e919));
let _e929 = select(_e927, _e925, (_e925 > _e927));
let _e931 = select(_e923, _e921, (_e921 < _e923));
let _e933 = select(_e931, _e929, (_e929 > _e931));
let _e935 = select(_e915, _e913, (_e913 > _e915));
let _e937 = select(_e919, _e917, (_e917 > _e919));
let _e939 = select(_e937, _e935, (_e935 < _e937));
let _e941 = select(_e923, _e921, (_e921 > _e923));
let _e945 = select(0f, _e933, (_e933 > 0f));
let _e950 = global_5.member.member_14.member.member;
let _e961 = ((((_e950.member.member * _e805) + (_e950.member.member_1 * _e806)) + (_e950.member.member_2 * _e807)) + _e950.member_1);
let _e967 = -((((_e950.member.member * _e818) + (_e950.member.member_1 * _e819)) + (_e950.member.member_2 * _e820)));
let _e969 = (_e967 > 1e-9f);
let _e971 = select(1e-9f, _e967, _e969);
let _e973 = ((_e961 / _e971) - 0.015625f);
let _e976 = select(1e30f, select(0f, _e973, (_e973 > 0f)), ((_e961 > 0f) && _e969));
let _e981 = global_5.member.member_14.member_1.member;
let _e992 = ((((_e981.member.member * _e805) + (_e981.member.member_1 * _e806)) + (_e981.member.member_2 * _e807)) + _e981.member_1);
let _e998 = -((((_e981.member.member * _e818) + (_e981.member.member_1 * _e819)) + (_e981.member.member_2 * _e820)));
let _e1000 = (_e998 > 1e-9f);
let _e1002 = select(1e-9f, _e998, _e1000);
let _e1004 = ((_e992 / _e1002) - 0.015625f);
let _e1007 = select(1e30f, select(0f, _e1004, (_e1004 > 0f)), ((_e992 > 0f) && _e1000));
let _e1013 = ((select(_e941, _e939, (_e939 < _e941)) <= _e945) || (true && (select(_e976, _e1007, (_e1007 < _e976)) <= _e945)));
let _e1014 = select(_e945, 0f, _e1013);
let _e1015 = (_e818 * _e1014);
let _e1016 = (_e819 * _e1014);
let _e1017 = (_e820 * _e1014);
let _e1018 = (_e805 + _e1015);
let _e1019 = (_e806 + _e1016);
let _e1020 = (_e807 + _e1017);
let _e1038 = ((((_e950.member.member * _e1018) + (_e950.member.member_1 * _e1019)) + (_e950.member.member_2 * _e1020)) + _e950.member_1);
let _e1042 = ((_e1038 / _e971) - 0.015625f);
let _e1045 = select(1e30f, select(0f, _e1042, (_e1042 > 0f)), ((_e1038 > 0f) && _e969));
let _e1051 = ((((_e981.member.member * _e1018) + (_e981.member.member_1 * _e1019)) + (_e981.member.member_2 * _e1020)) + _e981.member_1);
let _e1055 = ((_e1051 / _e1002) - 0.015625f);
let _e1058 = select(1e30f, select(0f, _e1055, (_e1055 > 0f)), ((_e1051 > 0f) && _e1000));
let _e1062 = (_e1058 < _e1045);
let _e1066 = type_25((vec3<f32>(_e805, _e806, _e807) + vec3<f32>(_e1015, _e1016, _e1017)), vec3<f32>(_e818, _e819, _e820), (vec3<f32>(select(0f, _e824, _e783), select(0f, _e825, _e783), select(0f, _e826, _e783)) + vec3<f32>((_e854 * _e1014), (_e855 * _e1014), (_e856 * _e1014))), (vec3<f32>(select(0f, _e829, _e783), select(0f, _e830, _e783), select(0f, _e831, _e783)) + vec3<f32>((_e872 * _e1014), (_e873 * _e1014), (_e874 * _e1014))), vec3<f32>(_e854, _e855, _e856), vec3<f32>(_e872, _e873, _e874), vec3<f32>(1f, 1f, 1f), 0i, 0i, select(select(-2i, -3i, _e1062), -1i, ((_e1045 >= 1e30f) && (_e1058 >= 1e30f))), select(_e1045, _e1058, _e1062), 0i, 0i, 0f, _e461, 1f, 0i, _e693, _e700, _e707, _e714, _e721, _e611, _e560, _e571, _e582, _e593, _e604);
let _e1070 = global_5.member.member_13.member_4;
let _e1077 = global_5.member.member_13.member_5;
let _e1082 = ((_e1070.member - _e805) * _e883);
let _e1084 = ((_e1077.member - _e805) * _e883);
let _e1086 = ((_e1070.member_1 - _e806) * _e891);
let _e1088 = ((_e1077.member_1 - _e806) * _e891);
let _e1090 = ((_e1070.member_2 - _e807) * _e899);
let _e1092 = ((_e1077.member_2 - _e807) * _e899);
let _e1094 = select(_e1084, _e1082, (_e1082 < _e1084));
let _e1096 = select(_e1088, _e1086, (_e1086 < _e1088));
let _e1098 = select(_e1096, _e1094, (_e1094 > _e1096));
let _e1100 = select(_e1092, _e1090, (_e1090 < _e1092));
let _e1102 = select(_e1100, _e1098, (_e1098 > _e1100));
let _e1104 = select(_e1084, _e1082, (_e1082 > _e1084));
let _e1106 = select(_e1088, _e1086, (_e1086 > _e1088));
let _e1108 = select(_e1106, _e1104, (_e1104 < _e1106));
let _e1110 = select(_e1092, _e1090, (_e1090 > _e1092));
let _e1112 = select(_e1110, _e1108, (_e1108 < _e1110));
let _e1114 = select(0f, _e1102, (_e1102 > 0f));
let _e1116 = select(_e1014, _e1112, (_e1112 < _e1014));
let _e1119 = (select(_e1114, _e1116, (_e1116 > _e1114)) - _e1114);
let _e1123 = global_5.member.member_13.member;
let _e1128 = -((_e1123.member * _e1119));
let _e1130 = select(-87f, _e1128, (_e1128 > -87f));
let _e1132 = select(88f, _e1130, (_e1130 < 88f));
let _e1134 = ((_e1132 * 1.442695f) + 0.5f);
let _e1136 = select(-127f, _e1134, (_e1134 > -127f));
let _e1138 = select(128f, _e1136, (_e1136 < 128f));
let _e1145 = select(0i, select(select(i32(_e1138), i32(-2147483648), (_e1138 < -2147483600f)), 2147483647i, (_e1138 > 2147483500f)), (_e1138 == _e1138));
let _e1149 = (_e1145 - select(0i, 1i, (_e1138 < f32(_e1145))));
let _e1150 = f32(_e1149);
let _e1154 = ((_e1132 - (_e1150 * 0.6933594f)) - (_e1150 * -2.1219444e-4f));
let _e1176 = -((_e1123.member_1 * _e1119));
let _e1178 = select(-87f, _e1176, (_e1176 > -87f));
let _e1180 = select(88f, _e1178, (_e1178 < 88f));
let _e1182 = ((_e1180 * 1.442695f) + 0.5f);
let _e1184 = select(-127f, _e1182, (_e1182 > -127f));
let _e1186 = select(128f, _e1184, (_e1184 < 128f));
let _e1193 = select(0i, select(select(i32(_e1186), i32(-2147483648), (_e1186 < -2147483600f)), 2147483647i, (_e1186 > 2147483500f)), (_e1186 == _e1186));
let _e1197 = (_e1193 - select(0i, 1i, (_e1186 < f32(_e1193))));
let _e1198 = f32(_e1197);
let _e1202 = ((_e1180 - (_e1198 * 0.6933594f)) - (_e1198 * -2.1219444e-4f));
let _e1224 = -((_e1123.member_2 * _e1119));
let _e1226 = select(-87f, _e1224, (_e1224 > -87f));
let _e1228 = select(88f, _e1226, (_e1226 < 88f));
let _e1230 = ((_e1228 * 1.442695f) + 0.5f);
let _e1232 = select(-127f, _e1230, (_e1230 > -127f));
let _e1234 = select(128f, _e1232, (_e1232 < 128f));
let _e1241 = select(0i, select(select(i32(_e1234), i32(-2147483648), (_e1234 < -2147483600f)), 2147483647i, (_e1234 > 2147483500f)), (_e1234 == _e1234));
let _e1245 = (_e1241 - select(0i, 1i, (_e1234 < f32(_e1241))));
let _e1246 = f32(_e1245);
let _e1250 = ((_e1228 - (_e1246 * 0.6933594f)) - (_e1246 * -2.1219444e-4f));
let _e1273 = (1f / 3f);
let _e1275 = (1f * ((1f + (_e1154 * (1f + (_e1154 * (0.5f + (_e1154 * (0.16666667f + (_e1154 * (0.041666668f + (_e1154 * (0.008333334f + (_e1154 * (0.001388889f + (_e1154 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1149 + 127i)) << bitcast<u32>(23i)))));
let _e1276 = (1f * ((1f + (_e1202 * (1f + (_e1202 * (0.5f + (_e1202 * (0.16666667f + (_e1202 * (0.041666668f + (_e1202 * (0.008333334f + (_e1202 * (0.001388889f + (_e1202 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1197 + 127i)) << bitcast<u32>(23i)))));
let _e1277 = (1f * ((1f + (_e1250 * (1f + (_e1250 * (0.5f + (_e1250 * (0.16666667f + (_e1250 * (0.041666668f + (_e1250 * (0.008333334f + (_e1250 * (0.001388889f + (_e1250 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1245 + 127i)) << bitcast<u32>(23i)))));
let _e1306 = type_25(_e1066.member, _e1066.member_1, _e1066.member_2, _e1066.member_3, _e1066.member_4, _e1066.member_5, vec3<f32>(_e1275, _e1276, _e1277), _e1066.member_7, _e1066.member_8, _e1066.member_9, _e1066.member_10, _e1066.member_11, _e1066.member_12, _e1066.member_13, _e1066.member_14, _e1066.member_15, _e1066.member_16, _e1066.member_17, _e1066.member_18, _e1066.member_19, _e1066.member_20, _e1066.member_21, _e1066.member_22, _e1066.member_23, _e1066.member_24, _e1066.member_25, _e1066.member_26, _e1066.member_27);
if (bitcast<i32>(countOneBits(0u)) == _e714) {
phi_2374_ = ((((1f + 1f) + 1f) * _e1273) - (((_e1275 + _e1276) + _e1277) * _e1273));
} else {
phi_2374_ = 0f;
}
let _e1315 = phi_2374_;
let _e1344 = type_25(_e1306.member, _e1306.member_1, _e1306.member_2, _e1306.member_3, _e1306.member_4, _e1306.member_5, _e1306.member_6, _e1306.member_7, _e1306.member_8, _e1306.member_9, _e1306.member_10, _e1306.member_11, _e1306.member_12, _e1306.member_13, _e1306.member_14, _e1306.member_15, _e1306.member_16, _e1306.member_17, _e1306.member_18, _e1306.member_19, _e1306.member_20, _e1306.member_21, _e1306.member_22, _e1306.member_23, _e1306.member_24, _e1306.member_25, (_e593 + _e1315), _e1306.member_27);
if _e1013 {
phi_2401_ = type_25(_e1344.member, _e1344.member_1, _e1344.member_2, _e1344.member_3, _e1344.member_4, _e1344.member_5, _e1344.member_6, _e1344.member_7, (bitcast<i32>(_e123) / 8i), _e1344.member_9, _e1344.member_10, _e1344.member_11, _e1344.member_12, _e1344.member_13, _e1344.member_14, _e1344.member_15, _e1344.member_16, _e1344.member_17, _e1344.member_18, _e1344.member_19, _e1344.member_20, _e1344.member_21, _e1344.member_22, _e1344.member_23, _e1344.member_24, _e1344.member_25, _e1344.member_26, _e1344.member_27);
} else {
phi_2401_ = _e1344;
}
let _e1376 = phi_2401_;
phi_2402_ = _e1376;
} else {
phi_2402_ = type_25(vec3<f32>(_e154, _e164, _e175), vec3<f32>(_e186, _e197, _e208), vec3<f32>(_e219, _e230, _e241), vec3<f32>(_e252, _e263, _e274), vec3<f32>(_e285, _e296, _e307), vec3<f32>(_e318, _e329, _e340), vec3<f32>(_e351, _e362, _e373), select(0i, select(select(i32(_e384), i32(-2147483648), (_e384 < -2147483600f)), 2147483647i, (_e384 > 2147483500f)), (_e384 == _e384)), select(0i, select(select(i32(_e395), i32(-2147483648), (_e395 < -2147483600f)), 2147483647i, (_e395 > 2147483500f)), (_e395 == _e395)), select(0i, select(select(i32(_e406), i32(-2147483648), (_e406 < -2147483600f)), 2147483647i, (_e406 > 2147483500f)), (_e406 == _e406)), _e417, select(0i, select(select(i32(_e428), i32(-2147483648), (_e428 < -2147483600f)), 2147483647i, (_e428 > 2147483500f)), (_e428 == _e428)), select(0i, select(select(i32(_e439), i32(-2147483648), (_e439 < -2147483600f)), 2147483647i, (_e439 > 2147483500f)), (_e439 == _e439)), _e450, _e461, _e472, select(0i, select(select(i32(_e483), i32(-2147483648), (_e483 < -2147483600f)), 2147483647i, (_e483 > 2147483500f)), (_e483 == _e483)), _e693, _e700, _e707, _e714, _e721, _e611, _e560, _e571, _e582, _e593, _e604);
}
let _e1378 = phi_2402_;
let _e1379 = bitcast<i32>(_e123);
let _e1380 = (_e1379 / 8i);
let _e1382 = (_e1378.member_15 == 2f);
if _e1382 {
phi_2422_ = type_25(_e1378.member, _e1378.member_1, _e1378.member_2, _e1378.member_3, _e1378.member_4, _e1378.member_5, _e1378.member_6, _e1378.member_7, _e1378.member_8, _e1378.member_9, _e1378.member_10, _e1378.member_11, _e1378.member_12, _e1378.member_13, _e1378.member_14, 1f, _e1378.member_16, _e1378.member_17, _e1378.member_18, _e1378.member_19, _e1378.member_20, _e1378.member_21, _e1378.member_22, _e1378.member_23, _e1378.member_24, _e1378.member_25, _e1378.member_26, _e1378.member_27);
} else {
phi_2422_ = _e1378;
}
let _e1412 = phi_2422_;
phi_2424_ = _e1412;
phi_2427_ = 0i;
phi_2429_ = _e1382;
loop {
let _e1414 = phi_2424_;
let _e1416 = phi_2427_;
let _e1418 = phi_2429_;
local_10 = _e1414;
local_11 = _e1414;
local_12 = _e1414;
local_13 = _e1414;
local_14 = _e1414;
local_15 = _e1414;
local_16 = _e1414;
local_17 = _e1414;
local_18 = _e1414;
local_19 = _e1414;
local_20 = _e1414;
local_21 = _e1414;
local_22 = _e1414;
local_23 = _e1414;
local_24 = _e1414;
local_25 = _e1414;
local_26 = _e1414;
local_27 = _e1414;
local_28 = _e1414;
local_29 = _e1414;
local_30 = _e1414;
local_31 = _e1414;
local_32 = _e1414;
local_33 = _e1414;
local_34 = _e1414;
local_35 = _e1414;
local_36 = _e1414;
local_37 = _e1414;
local_38 = _e1414;
local_39 = _e1414;
local_40 = _e1414;
local_41 = _e1414;
local_42 = _e1414;
local_43 = _e1414;
local_44 = _e1414;
local_45 = _e1414;
local_46 = _e1414;
local_47 = _e1414;
local_48 = _e1414;
local_49 = _e1414;
local_50 = _e1414;
let _e1422 = ((_e1416 < 1024i) && (_e1414.member_15 == 1f));
local_51 = _e1414.member_15;
if _e1422 {
if (_e1414.member_8 < _e1380) {
let _e7286 = f32(_e1414.member_11);
let _e7288 = f32(_e1414.member_12);
let _e7290 = vec3<f32>(_e7286, _e7288, _e1414.member_13);
let _e7292 = (_e1414.member_9 >= 0i);
if _e7292 {
let _e7293 = (_e1414.member_9 * 19i);
let _e7295 = (bitcast<i32>(_e125) - 1i);
let _e7297 = select(_e7295, _e7293, (_e7293 < _e7295));
let _e7303 = global_2.member[bitcast<u32>(select(0i, _e7297, (_e7297 > 0i)))];
let _e7304 = (_e7293 + 1i);
let _e7306 = select(_e7295, _e7304, (_e7304 < _e7295));
let _e7312 = global_2.member[bitcast<u32>(select(0i, _e7306, (_e7306 > 0i)))];
let _e7313 = (_e7293 + 2i);
let _e7315 = select(_e7295, _e7313, (_e7313 < _e7295));
let _e7321 = global_2.member[bitcast<u32>(select(0i, _e7315, (_e7315 > 0i)))];
let _e7322 = (_e7293 + 3i);
let _e7324 = select(_e7295, _e7322, (_e7322 < _e7295));
let _e7330 = global_2.member[bitcast<u32>(select(0i, _e7324, (_e7324 > 0i)))];
let _e7331 = (_e7293 + 4i);
let _e7333 = select(_e7295, _e7331, (_e7331 < _e7295));
let _e7339 = global_2.member[bitcast<u32>(select(0i, _e7333, (_e7333 > 0i)))];
let _e7340 = (_e7293 + 5i);
let _e7342 = select(_e7295, _e7340, (_e7340 < _e7295));
let _e7348 = global_2.member[bitcast<u32>(select(0i, _e7342, (_e7342 > 0i)))];
let _e7349 = (_e7330 - _e7303);
let _e7350 = (_e7339 - _e7312);
let _e7351 = (_e7348 - _e7321);
let _e7352 = (_e7293 + 6i);
let _e7354 = select(_e7295, _e7352, (_e7352 < _e7295));
let _e7360 = global_2.member[bitcast<u32>(select(0i, _e7354, (_e7354 > 0i)))];
let _e7361 = (_e7293 + 7i);
let _e7363 = select(_e7295, _e7361, (_e7361 < _e7295));
let _e7369 = global_2.member[bitcast<u32>(select(0i, _e7363, (_e7363 > 0i)))];
let _e7370 = (_e7293 + 8i);
let _e7372 = select(_e7295, _e7370, (_e7370 < _e7295));
let _e7378 = global_2.member[bitcast<u32>(select(0i, _e7372, (_e7372 > 0i)))];
let _e7379 = (_e7360 - _e7303);
let _e7380 = (_e7369 - _e7312);
let _e7381 = (_e7378 - _e7321);
let _e7384 = ((_e7350 * _e7381) - (_e7351 * _e7380));
let _e7387 = ((_e7351 * _e7379) - (_e7349 * _e7381));
let _e7390 = ((_e7349 * _e7380) - (_e7350 * _e7379));
let _e7395 = (((_e7384 * _e7384) + (_e7387 * _e7387)) + (_e7390 * _e7390));
let _e7398 = sqrt(select(0f, _e7395, (_e7395 > 0f)));
let _e7401 = (1f / select(1e-20f, _e7398, (_e7398 > 1e-20f)));
phi_2655_ = (((_e1414.member_1.x * (_e7384 * _e7401)) + (_e1414.member_1.y * (_e7387 * _e7401))) + (_e1414.member_1.z * (_e7390 * _e7401)));
} else {
phi_2655_ = 1f;
}
let _e7414 = phi_2655_;
let _e7421 = select(0i, select(select(i32(_e7286), i32(-2147483648), (_e7286 < -2147483600f)), 2147483647i, (_e7286 > 2147483500f)), (_e7286 == _e7286));
let _e7428 = select(0i, select(select(i32(_e7288), i32(-2147483648), (_e7288 < -2147483600f)), 2147483647i, (_e7288 > 2147483500f)), (_e7288 == _e7288));
let _e7431 = bitcast<f32>((bitcast<u32>(_e7414) & 2147483647u));
let _e7433 = select(1e-3f, _e7431, (_e7431 > 1e-3f));
let _e7434 = type_26(_e7421, _e7428, _e1414.member_13, _e1414.member_14, _e7433);
let _e7439 = global_5.member.member_12.member;
let _e7442 = (_e1414.member_10 + select(0f, (_e7439 / _e7433), _e7292));
let _e7446 = (_e1414.member_8 * 8i);
let _e7449 = bitcast<f32>((bitcast<u32>(_e1414.member_1.x) & 2147483647u));
let _e7454 = (1f / select(_e1414.member_1.x, select(1e-12f, -1e-12f, (_e1414.member_1.x < 0f)), (_e7449 < 1e-12f)));
let _e7457 = bitcast<f32>((bitcast<u32>(_e1414.member_1.y) & 2147483647u));
let _e7462 = (1f / select(_e1414.member_1.y, select(1e-12f, -1e-12f, (_e1414.member_1.y < 0f)), (_e7457 < 1e-12f)));
let _e7465 = bitcast<f32>((bitcast<u32>(_e1414.member_1.z) & 2147483647u));
let _e7470 = (1f / select(_e1414.member_1.z, select(1e-12f, -1e-12f, (_e1414.member_1.z < 0f)), (_e7465 < 1e-12f)));
let _e7471 = (_e1379 - 1i);
let _e7473 = select(_e7471, _e7446, (_e7446 < _e7471));
let _e7479 = global_1.member[bitcast<u32>(select(0i, _e7473, (_e7473 > 0i)))];
let _e7480 = (_e7446 + 1i);
let _e7482 = select(_e7471, _e7480, (_e7480 < _e7471));
let _e7488 = global_1.member[bitcast<u32>(select(0i, _e7482, (_e7482 > 0i)))];
let _e7489 = (_e7446 + 2i);
let _e7491 = select(_e7471, _e7489, (_e7489 < _e7471));
let _e7497 = global_1.member[bitcast<u32>(select(0i, _e7491, (_e7491 > 0i)))];
let _e7498 = (_e7446 + 3i);
let _e7500 = select(_e7471, _e7498, (_e7498 < _e7471));
let _e7506 = global_1.member[bitcast<u32>(select(0i, _e7500, (_e7500 > 0i)))];
let _e7507 = (_e7446 + 4i);
let _e7509 = select(_e7471, _e7507, (_e7507 < _e7471));
let _e7515 = global_1.member[bitcast<u32>(select(0i, _e7509, (_e7509 > 0i)))];
let _e7516 = (_e7446 + 5i);
let _e7518 = select(_e7471, _e7516, (_e7516 < _e7471));
let _e7524 = global_1.member[bitcast<u32>(select(0i, _e7518, (_e7518 > 0i)))];
let _e7527 = ((_e7479 - _e1414.member.x) * _e7454);
let _e7529 = ((_e7506 - _e1414.member.x) * _e7454);
let _e7532 = ((_e7488 - _e1414.member.y) * _e7462);
let _e7534 = ((_e7515 - _e1414.member.y) * _e7462);
let _e7537 = ((_e7497 - _e1414.member.z) * _e7470);
let _e7539 = ((_e7524 - _e1414.member.z) * _e7470);
let _e7541 = select(_e7529, _e7527, (_e7527 < _e7529));
let _e7543 = select(_e7534, _e7532, (_e7532 < _e7534));
let _e7545 = select(_e7543, _e7541, (_e7541 > _e7543));
let _e7547 = select(_e7539, _e7537, (_e7537 < _e7539));
let _e7551 = select(_e7529, _e7527, (_e7527 > _e7529));
let _e7553 = select(_e7534, _e7532, (_e7532 > _e7534));
let _e7555 = select(_e7553, _e7551, (_e7551 < _e7553));
let _e7557 = select(_e7539, _e7537, (_e7537 > _e7539));
let _e7559 = select(_e7557, _e7555, (_e7555 < _e7557));
let _e7564 = ((select(_e7547, _e7545, (_e7545 > _e7547)) <= select(_e7442, _e7559, (_e7559 < _e7442))) && (_e7559 >= _e1414.member_13));
let _e7565 = (_e7446 + 6i);
let _e7567 = select(_e7471, _e7565, (_e7565 < _e7471));
let _e7573 = global_1.member[bitcast<u32>(select(0i, _e7567, (_e7567 > 0i)))];
if _e7564 {
phi_2968_ = (_e1414.member_8 + 1i);
} else {
let _e7581 = (_e7446 + 7i);
let _e7583 = select(_e7471, _e7581, (_e7581 < _e7471));
let _e7589 = global_1.member[bitcast<u32>(select(0i, _e7583, (_e7583 > 0i)))];
phi_2968_ = select(0i, select(select(i32(_e7589), i32(-2147483648), (_e7589 < -2147483600f)), 2147483647i, (_e7589 > 2147483500f)), (_e7589 == _e7589));
}
let _e7599 = phi_2968_;
let _e7600 = type_17(_e1414.member, _e1414.member_1, vec3<f32>(1f, 1f, 1f), vec3<f32>(0f, 0f, 0f), _e7290, _e1414.member_14, 0f, 16i, 0f, 0f, 0f, 0f, vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f), 0i, _e7599, _e1414.member_9, _e1414.member_10);
let _e7601 = select(-1i, select(0i, select(select(i32(_e7573), i32(-2147483648), (_e7573 < -2147483600f)), 2147483647i, (_e7573 > 2147483500f)), (_e7573 == _e7573)), _e7564);
if (_e7601 < 0i) {
phi_3748_ = type_26();
phi_3749_ = type_17();
phi_3750_ = true;
} else {
let _e7605 = ((_e7449 >= _e7457) && (_e7449 >= _e7465));
let _e7608 = (!(_e7605) && (_e7457 >= _e7465));
let _e7615 = (1f / select(select(_e1414.member_1.z, _e1414.member_1.y, _e7608), _e1414.member_1.x, _e7605));
let _e7616 = (select(select(_e1414.member_1.x, _e1414.member_1.z, _e7608), _e1414.member_1.y, _e7605) * _e7615);
let _e7617 = (select(select(_e1414.member_1.y, _e1414.member_1.x, _e7608), _e1414.member_1.z, _e7605) * _e7615);
let _e7618 = (_e7601 * 19i);
let _e7620 = (bitcast<i32>(_e125) - 1i);
let _e7622 = select(_e7620, _e7618, (_e7618 < _e7620));
let _e7628 = global_2.member[bitcast<u32>(select(0i, _e7622, (_e7622 > 0i)))];
let _e7629 = (_e7618 + 1i);
let _e7631 = select(_e7620, _e7629, (_e7629 < _e7620));
let _e7637 = global_2.member[bitcast<u32>(select(0i, _e7631, (_e7631 > 0i)))];
let _e7638 = (_e7618 + 2i);
let _e7640 = select(_e7620, _e7638, (_e7638 < _e7620));
let _e7646 = global_2.member[bitcast<u32>(select(0i, _e7640, (_e7640 > 0i)))];
let _e7647 = (_e7628 - _e1414.member.x);
let _e7648 = (_e7637 - _e1414.member.y);
let _e7649 = (_e7646 - _e1414.member.z);
let _e7655 = select(select(_e7649, _e7648, _e7608), _e7647, _e7605);
let _e7657 = (select(select(_e7647, _e7649, _e7608), _e7648, _e7605) - (_e7616 * _e7655));
let _e7659 = (select(select(_e7648, _e7647, _e7608), _e7649, _e7605) - (_e7617 * _e7655));
let _e7661 = (_e7618 + 3i);
let _e7663 = select(_e7620, _e7661, (_e7661 < _e7620));
let _e7669 = global_2.member[bitcast<u32>(select(0i, _e7663, (_e7663 > 0i)))];
let _e7670 = (_e7618 + 4i);
let _e7672 = select(_e7620, _e7670, (_e7670 < _e7620));
let _e7678 = global_2.member[bitcast<u32>(select(0i, _e7672, (_e7672 > 0i)))];
let _e7679 = (_e7618 + 5i);
let _e7681 = select(_e7620, _e7679, (_e7679 < _e7620));
let _e7687 = global_2.member[bitcast<u32>(select(0i, _e7681, (_e7681 > 0i)))];
let _e7688 = (_e7669 - _e1414.member.x);
let _e7689 = (_e7678 - _e1414.member.y);
let _e7690 = (_e7687 - _e1414.member.z);
let _e7696 = select(select(_e7690, _e7689, _e7608), _e7688, _e7605);
let _e7698 = (select(select(_e7688, _e7690, _e7608), _e7689, _e7605) - (_e7616 * _e7696));
let _e7700 = (select(select(_e7689, _e7688, _e7608), _e7690, _e7605) - (_e7617 * _e7696));
let _e7702 = (_e7618 + 6i);
let _e7704 = select(_e7620, _e7702, (_e7702 < _e7620));
let _e7710 = global_2.member[bitcast<u32>(select(0i, _e7704, (_e7704 > 0i)))];
let _e7711 = (_e7618 + 7i);
let _e7713 = select(_e7620, _e7711, (_e7711 < _e7620));
let _e7719 = global_2.member[bitcast<u32>(select(0i, _e7713, (_e7713 > 0i)))];
let _e7720 = (_e7618 + 8i);
let _e7722 = select(_e7620, _e7720, (_e7720 < _e7620));
let _e7728 = global_2.member[bitcast<u32>(select(0i, _e7722, (_e7722 > 0i)))];
let _e7729 = (_e7710 - _e1414.member.x);
let _e7730 = (_e7719 - _e1414.member.y);
let _e7731 = (_e7728 - _e1414.member.z);
let _e7737 = select(select(_e7731, _e7730, _e7608), _e7729, _e7605);
let _e7739 = (select(select(_e7729, _e7731, _e7608), _e7730, _e7605) - (_e7616 * _e7737));
let _e7741 = (select(select(_e7730, _e7729, _e7608), _e7731, _e7605) - (_e7617 * _e7737));
let _e7745 = ((_e7739 * _e7700) - (_e7741 * _e7698));
let _e7748 = ((_e7657 * _e7741) - (_e7659 * _e7739));
let _e7751 = ((_e7698 * _e7659) - (_e7700 * _e7657));
let _e7753 = ((_e7745 + _e7748) + _e7751);
let _e7767 = (!(((((_e7745 < 0f) || (_e7748 < 0f)) || (_e7751 < 0f)) && (((_e7745 > 0f) || (_e7748 > 0f)) || (_e7751 > 0f)))) && (_e7753 != 0f));
let _e7775 = select(1e30f, ((((_e7745 * (_e7655 * _e7615)) + (_e7748 * (_e7696 * _e7615))) + (_e7751 * (_e7737 * _e7615))) / select(1f, _e7753, _e7767)), _e7767);
if (_e7775 >= _e7442) {
phi_3742_ = type_26();
phi_3743_ = type_17();
phi_3744_ = true;
} else {
let _e7777 = (_e7669 - _e7628);
let _e7778 = (_e7678 - _e7637);
let _e7779 = (_e7687 - _e7646);
let _e7780 = (_e7710 - _e7628);
let _e7781 = (_e7719 - _e7637);
let _e7782 = (_e7728 - _e7646);
let _e7785 = ((_e7778 * _e7782) - (_e7779 * _e7781));
let _e7788 = ((_e7779 * _e7780) - (_e7777 * _e7782));
let _e7791 = ((_e7777 * _e7781) - (_e7778 * _e7780));
let _e7796 = (((_e7785 * _e7785) + (_e7788 * _e7788)) + (_e7791 * _e7791));
let _e7799 = sqrt(select(0f, _e7796, (_e7796 > 0f)));
let _e7802 = (1f / select(1e-20f, _e7799, (_e7799 > 1e-20f)));
let _e7810 = (((_e1414.member_1.x * (_e7785 * _e7802)) + (_e1414.member_1.y * (_e7788 * _e7802))) + (_e1414.member_1.z * (_e7791 * _e7802)));
let _e7813 = bitcast<f32>((bitcast<u32>(_e7810) & 2147483647u));
let _e7815 = select(1e-3f, _e7813, (_e7813 > 1e-3f));
let _e7816 = (_e7618 + 18i);
let _e7818 = select(_e7620, _e7816, (_e7816 < _e7620));
let _e7824 = global_2.member[bitcast<u32>(select(0i, _e7818, (_e7818 > 0i)))];
let _e7831 = select(0i, select(select(i32(_e7824), i32(-2147483648), (_e7824 < -2147483600f)), 2147483647i, (_e7824 > 2147483500f)), (_e7824 == _e7824));
let _e7832 = (_e7831 * 4i);
let _e7834 = (bitcast<i32>(_e127) - 1i);
let _e7836 = select(_e7834, _e7832, (_e7832 < _e7834));
let _e7842 = global_3.member[bitcast<u32>(select(0i, _e7836, (_e7836 > 0i)))];
let _e7844 = select(_e7842, 1f, (_e7831 == 16i));
let _e7845 = (_e7844 <= 0f);
if _e7845 {
phi_3579_ = 0i;
} else {
phi_3579_ = (1i << bitcast<u32>((_e7831 & 31i)));
}
let _e7850 = phi_3579_;
let _e7851 = (_e7810 < 0f);
let _e7852 = select(_e7850, 0i, _e7851);
let _e7853 = select(0i, _e7850, _e7851);
let _e7862 = (_e7775 * _e7815);
let _e7875 = (((_e7775 > _e1414.member_13) && (_e1414.member_13 > 0f)) || (((_e7862 > (_e7439 * 2f)) || ((((_e7844 == 0f) || ((_e7853 & ~(_e1414.member_7)) != 0i)) || ((_e7852 & _e1414.member_7) != 0i)) && (_e7862 >= -((_e7439 * 0.5f))))) && (_e1414.member_13 <= 0f)));
if _e7875 {
let _e7876 = (_e7775 < _e1414.member_10);
if (_e7292 && ((bitcast<f32>((bitcast<u32>((_e7775 - _e1414.member_10)) & 2147483647u)) * select(_e7433, _e7815, (_e7815 > _e7433))) <= _e7439)) {
let _e7895 = ((_e1414.member_9 * 19i) + 18i);
let _e7897 = select(_e7620, _e7895, (_e7895 < _e7620));
let _e7903 = global_2.member[bitcast<u32>(select(0i, _e7897, (_e7897 > 0i)))];
let _e7910 = select(0i, select(select(i32(_e7903), i32(-2147483648), (_e7903 < -2147483600f)), 2147483647i, (_e7903 > 2147483500f)), (_e7903 == _e7903));
let _e7911 = (_e7910 * 4i);
let _e7913 = select(_e7834, _e7911, (_e7911 < _e7834));
let _e7919 = global_3.member[bitcast<u32>(select(0i, _e7913, (_e7913 > 0i)))];
if (_e7845 != (select(_e7919, 1f, (_e7910 == 16i)) <= 0f)) {
phi_3724_ = _e7845;
} else {
if (!(_e7845) && (_e7831 != _e7910)) {
phi_3723_ = (_e7831 < _e7910);
} else {
phi_3723_ = _e7876;
}
let _e7929 = phi_3723_;
phi_3724_ = _e7929;
}
let _e7931 = phi_3724_;
phi_3730_ = type_26((_e7421 | _e7853), (_e7428 | _e7852), _e1414.member_13, select(_e7775, _e1414.member_14, (_e1414.member_14 > _e7775)), _e7433);
phi_3731_ = _e7931;
} else {
if _e7876 {
phi_3729_ = type_26(_e7853, _e7852, _e1414.member_13, _e7775, _e7433);
} else {
phi_3729_ = _e7434;
}
let _e7888 = phi_3729_;
phi_3730_ = _e7888;
phi_3731_ = _e7876;
}
let _e7933 = phi_3730_;
let _e7935 = phi_3731_;
if _e7935 {
phi_3738_ = type_17(_e1414.member, _e1414.member_1, vec3<f32>(1f, 1f, 1f), vec3<f32>(0f, 0f, 0f), _e7290, _e1414.member_14, 0f, 16i, 0f, 0f, 0f, 0f, vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f), 0i, _e7599, _e7601, _e7775);
} else {
phi_3738_ = _e7600;
}
let _e7938 = phi_3738_;
phi_3739_ = _e7933;
phi_3740_ = _e7938;
} else {
phi_3739_ = type_26();
phi_3740_ = type_17();
}
let _e7940 = phi_3739_;
let _e7942 = phi_3740_;
phi_3742_ = _e7940;
phi_3743_ = _e7942;
phi_3744_ = select(true, false, _e7875);
}
let _e7945 = phi_3742_;
let _e7947 = phi_3743_;
let _e7949 = phi_3744_;
phi_3748_ = _e7945;
phi_3749_ = _e7947;
phi_3750_ = _e7949;
}
let _e7951 = phi_3748_;
let _e7953 = phi_3749_;
let _e7955 = phi_3750_;
if _e7955 {
phi_3754_ = _e7434;
phi_3755_ = _e7600;
} else {
phi_3754_ = _e7951;
phi_3755_ = _e7953;
}
let _e7957 = phi_3754_;
let _e7959 = phi_3755_;
let _e7988 = type_25(_e1414.member, _e1414.member_1, _e1414.member_2, _e1414.member_3, _e1414.member_4, _e1414.member_5, _e1414.member_6, _e1414.member_7, _e7959.member_15, _e1414.member_9, _e1414.member_10, _e1414.member_11, _e1414.member_12, _e1414.member_13, _e1414.member_14, _e1414.member_15, _e1414.member_16, _e1414.member_17, _e1414.member_18, _e1414.member_19, _e1414.member_20, _e1414.member_21, _e1414.member_22, _e1414.member_23, _e1414.member_24, _e1414.member_25, _e1414.member_26, _e1414.member_27);
let _e8017 = type_25(_e7988.member, _e7988.member_1, _e7988.member_2, _e7988.member_3, _e7988.member_4, _e7988.member_5, _e7988.member_6, _e7988.member_7, _e7988.member_8, _e7959.member_16, _e7988.member_10, _e7988.member_11, _e7988.member_12, _e7988.member_13, _e7988.member_14, _e7988.member_15, _e7988.member_16, _e7988.member_17, _e7988.member_18, _e7988.member_19, _e7988.member_20, _e7988.member_21, _e7988.member_22, _e7988.member_23, _e7988.member_24, _e7988.member_25, _e7988.member_26, _e7988.member_27);
let _e8046 = type_25(_e8017.member, _e8017.member_1, _e8017.member_2, _e8017.member_3, _e8017.member_4, _e8017.member_5, _e8017.member_6, _e8017.member_7, _e8017.member_8, _e8017.member_9, _e7959.member_17, _e8017.member_11, _e8017.member_12, _e8017.member_13, _e8017.member_14, _e8017.member_15, _e8017.member_16, _e8017.member_17, _e8017.member_18, _e8017.member_19, _e8017.member_20, _e8017.member_21, _e8017.member_22, _e8017.member_23, _e8017.member_24, _e8017.member_25, _e8017.member_26, _e8017.member_27);
let _e8075 = type_25(_e8046.member, _e8046.member_1, _e8046.member_2, _e8046.member_3, _e8046.member_4, _e8046.member_5, _e8046.member_6, _e8046.member_7, _e8046.member_8, _e8046.member_9, _e8046.member_10, _e7957.member, _e8046.member_12, _e8046.member_13, _e8046.member_14, _e8046.member_15, _e8046.member_16, _e8046.member_17, _e8046.member_18, _e8046.member_19, _e8046.member_20, _e8046.member_21, _e8046.member_22, _e8046.member_23, _e8046.member_24, _e8046.member_25, _e8046.member_26, _e8046.member_27);
let _e8104 = type_25(_e8075.member, _e8075.member_1, _e8075.member_2, _e8075.member_3, _e8075.member_4, _e8075.member_5, _e8075.member_6, _e8075.member_7, _e8075.member_8, _e8075.member_9, _e8075.member_10, _e8075.member_11, _e7957.member_1, _e8075.member_13, _e8075.member_14, _e8075.member_15, _e8075.member_16, _e8075.member_17, _e8075.member_18, _e8075.member_19, _e8075.member_20, _e8075.member_21, _e8075.member_22, _e8075.member_23, _e8075.member_24, _e8075.member_25, _e8075.member_26, _e8075.member_27);
phi_9411_ = type_25(_e8104.member, _e8104.member_1, _e8104.member_2, _e8104.member_3, _e8104.member_4, _e8104.member_5, _e8104.member_6, _e8104.member_7, _e8104.member_8, _e8104.member_9, _e8104.member_10, _e8104.member_11, _e8104.member_12, _e8104.member_13, _e7957.member_3, _e8104.member_15, _e8104.member_16, _e8104.member_17, _e8104.member_18, _e8104.member_19, _e8104.member_20, _e8104.member_21, _e8104.member_22, _e8104.member_23, _e8104.member_24, _e8104.member_25, _e8104.member_26, _e8104.member_27);
phi_9412_ = _e1418;
} else {
phi_3770_ = 15i;
phi_3773_ = 16i;
loop {
let _e1428 = phi_3770_;
let _e1430 = phi_3773_;
local = _e1430;
local_1 = _e1430;
local_2 = _e1430;
local_4 = _e1430;
local_7 = _e1430;
let _e1431 = (_e1428 >= 0i);
if _e1431 {
phi_3771_ = (_e1428 - 1i);
phi_3774_ = select(_e1430, _e1428, (((_e1414.member_7 >> bitcast<u32>((_e1428 & 31i))) & 1i) == 1i));
} else {
phi_3771_ = i32();
phi_3774_ = i32();
}
let _e1440 = phi_3771_;
let _e1442 = phi_3774_;
continue;
continuing {
phi_3770_ = _e1440;
phi_3773_ = _e1442;
break if !(_e1431);
}
}
let _e1445 = local;
let _e1446 = (_e1445 == 16i);
let _e1458 = (bitcast<i32>(countOneBits(bitcast<u32>((_e1414.member_17 & ((1i << bitcast<u32>((_e1414.member_16 & 31i))) - 1i))))) == _e1414.member_20);
let _e1461 = ((_e1446 && _e1458) && !(_e1418));
if _e1461 {
let _e7247 = type_25(_e1414.member, _e1414.member_1, _e1414.member_2, _e1414.member_3, _e1414.member_4, _e1414.member_5, _e1414.member_6, _e1414.member_7, _e1414.member_8, _e1414.member_9, _e1414.member_10, _e1414.member_11, _e1414.member_12, _e1414.member_13, _e1414.member_14, 2f, _e1414.member_16, _e1414.member_17, _e1414.member_18, _e1414.member_19, _e1414.member_20, _e1414.member_21, _e1414.member_22, _e1414.member_23, _e1414.member_24, _e1414.member_25, _e1414.member_26, _e1414.member_27);
phi_9409_ = type_25(_e7247.member, _e7247.member_1, _e7247.member_2, _e7247.member_3, _e7247.member_4, _e7247.member_5, _e7247.member_6, _e7247.member_7, _e7247.member_8, _e7247.member_9, _e7247.member_10, _e7247.member_11, _e7247.member_12, _e7247.member_13, _e7247.member_14, _e7247.member_15, _e7247.member_16, _e7247.member_17, _e7247.member_18, _e7247.member_19, _e7247.member_20, _e7247.member_21, (_e1414.member_22 + 1i), _e7247.member_23, _e7247.member_24, _e7247.member_25, _e7247.member_26, _e7247.member_27);
} else {
let _e1463 = (_e1414.member_9 >= 0i);
let _e1466 = (_e1414.member_10 - _e1414.member_13);
let _e1468 = select(0f, _e1466, (_e1466 > 0f));
let _e1471 = ((select(0i, _e1414.member_9, _e1463) * 19i) + 18i);
let _e1473 = (bitcast<i32>(_e125) - 1i);
let _e1475 = select(_e1473, _e1471, (_e1471 < _e1473));
let _e1481 = global_2.member[bitcast<u32>(select(0i, _e1475, (_e1475 > 0i)))];
let _e1488 = select(0i, select(select(i32(_e1481), i32(-2147483648), (_e1481 < -2147483600f)), 2147483647i, (_e1481 > 2147483500f)), (_e1481 == _e1481));
let _e1489 = (_e1488 * 4i);
let _e1491 = (bitcast<i32>(_e127) - 1i);
let _e1493 = select(_e1491, _e1489, (_e1489 < _e1491));
let _e1499 = global_3.member[bitcast<u32>(select(0i, _e1493, (_e1493 > 0i)))];
let _e1501 = select(_e1499, 1f, (_e1488 == 16i));
let _e1503 = (_e1463 && (_e1501 <= 0f));
let _e1512 = ((_e1414.member_7 | (_e1414.member_11 & ~(_e1414.member_12))) & ~((_e1414.member_12 & ~(_e1414.member_11))));
phi_3894_ = 15i;
phi_3897_ = 16i;
loop {
let _e1514 = phi_3894_;
let _e1516 = phi_3897_;
local_3 = _e1516;
local_5 = _e1516;
local_6 = _e1516;
local_8 = _e1516;
local_9 = _e1516;
let _e1517 = (_e1514 >= 0i);
if _e1517 {
phi_3895_ = (_e1514 - 1i);
phi_3898_ = select(_e1516, _e1514, (((_e1512 >> bitcast<u32>((_e1514 & 31i))) & 1i) == 1i));
} else {
phi_3895_ = i32();
phi_3898_ = i32();
}
let _e1526 = phi_3895_;
let _e1528 = phi_3898_;
continue;
continuing {
phi_3894_ = _e1526;
phi_3897_ = _e1528;
break if !(_e1517);
}
}
if _e1446 {
let _e1798 = (1f / select(_e1414.member_1.x, select(1e-12f, -1e-12f, (_e1414.member_1.x < 0f)), (bitcast<f32>((bitcast<u32>(_e1414.member_1.x) & 2147483647u)) < 1e-12f)));
let _e1807 = (1f / select(_e1414.member_1.y, select(1e-12f, -1e-12f, (_e1414.member_1.y < 0f)), (bitcast<f32>((bitcast<u32>(_e1414.member_1.y) & 2147483647u)) < 1e-12f)));
let _e1816 = (1f / select(_e1414.member_1.z, select(1e-12f, -1e-12f, (_e1414.member_1.z < 0f)), (bitcast<f32>((bitcast<u32>(_e1414.member_1.z) & 2147483647u)) < 1e-12f)));
let _e1820 = global_5.member.member_13.member_4;
let _e1827 = global_5.member.member_13.member_5;
let _e1833 = ((_e1820.member - _e1414.member.x) * _e1798);
let _e1835 = ((_e1827.member - _e1414.member.x) * _e1798);
let _e1838 = ((_e1820.member_1 - _e1414.member.y) * _e1807);
let _e1840 = ((_e1827.member_1 - _e1414.member.y) * _e1807);
let _e1843 = ((_e1820.member_2 - _e1414.member.z) * _e1816);
let _e1845 = ((_e1827.member_2 - _e1414.member.z) * _e1816);
let _e1847 = select(_e1835, _e1833, (_e1833 < _e1835));
let _e1849 = select(_e1840, _e1838, (_e1838 < _e1840));
let _e1851 = select(_e1849, _e1847, (_e1847 > _e1849));
let _e1853 = select(_e1845, _e1843, (_e1843 < _e1845));
let _e1855 = select(_e1853, _e1851, (_e1851 > _e1853));
let _e1857 = select(_e1835, _e1833, (_e1833 > _e1835));
let _e1859 = select(_e1840, _e1838, (_e1838 > _e1840));
let _e1861 = select(_e1859, _e1857, (_e1857 < _e1859));
let _e1863 = select(_e1845, _e1843, (_e1843 > _e1845));
let _e1865 = select(_e1863, _e1861, (_e1861 < _e1863));
let _e1867 = select(0f, _e1855, (_e1855 > 0f));
let _e1869 = select(_e1414.member_10, _e1865, (_e1865 < _e1414.member_10));
let _e1872 = (select(_e1867, _e1869, (_e1869 > _e1867)) - _e1867);
let _e1876 = global_5.member.member_13.member;
let _e1881 = -((_e1876.member * _e1872));
let _e1883 = select(-87f, _e1881, (_e1881 > -87f));
let _e1885 = select(88f, _e1883, (_e1883 < 88f));
let _e1887 = ((_e1885 * 1.442695f) + 0.5f);
let _e1889 = select(-127f, _e1887, (_e1887 > -127f));
let _e1891 = select(128f, _e1889, (_e1889 < 128f));
let _e1898 = select(0i, select(select(i32(_e1891), i32(-2147483648), (_e1891 < -2147483600f)), 2147483647i, (_e1891 > 2147483500f)), (_e1891 == _e1891));
let _e1902 = (_e1898 - select(0i, 1i, (_e1891 < f32(_e1898))));
let _e1903 = f32(_e1902);
let _e1907 = ((_e1885 - (_e1903 * 0.6933594f)) - (_e1903 * -2.1219444e-4f));
let _e1929 = -((_e1876.member_1 * _e1872));
let _e1931 = select(-87f, _e1929, (_e1929 > -87f));
let _e1933 = select(88f, _e1931, (_e1931 < 88f));
let _e1935 = ((_e1933 * 1.442695f) + 0.5f);
let _e1937 = select(-127f, _e1935, (_e1935 > -127f));
let _e1939 = select(128f, _e1937, (_e1937 < 128f));
let _e1946 = select(0i, select(select(i32(_e1939), i32(-2147483648), (_e1939 < -2147483600f)), 2147483647i, (_e1939 > 2147483500f)), (_e1939 == _e1939));
let _e1950 = (_e1946 - select(0i, 1i, (_e1939 < f32(_e1946))));
let _e1951 = f32(_e1950);
let _e1955 = ((_e1933 - (_e1951 * 0.6933594f)) - (_e1951 * -2.1219444e-4f));
let _e1977 = -((_e1876.member_2 * _e1872));
let _e1979 = select(-87f, _e1977, (_e1977 > -87f));
let _e1981 = select(88f, _e1979, (_e1979 < 88f));
let _e1983 = ((_e1981 * 1.442695f) + 0.5f);
let _e1985 = select(-127f, _e1983, (_e1983 > -127f));
let _e1987 = select(128f, _e1985, (_e1985 < 128f));
let _e1994 = select(0i, select(select(i32(_e1987), i32(-2147483648), (_e1987 < -2147483600f)), 2147483647i, (_e1987 > 2147483500f)), (_e1987 == _e1987));
let _e1998 = (_e1994 - select(0i, 1i, (_e1987 < f32(_e1994))));
let _e1999 = f32(_e1998);
let _e2003 = ((_e1981 - (_e1999 * 0.6933594f)) - (_e1999 * -2.1219444e-4f));
let _e2030 = (1f / 3f);
let _e2034 = (_e1414.member_6.x * ((1f + (_e1907 * (1f + (_e1907 * (0.5f + (_e1907 * (0.16666667f + (_e1907 * (0.041666668f + (_e1907 * (0.008333334f + (_e1907 * (0.001388889f + (_e1907 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1902 + 127i)) << bitcast<u32>(23i)))));
let _e2037 = (_e1414.member_6.y * ((1f + (_e1955 * (1f + (_e1955 * (0.5f + (_e1955 * (0.16666667f + (_e1955 * (0.041666668f + (_e1955 * (0.008333334f + (_e1955 * (0.001388889f + (_e1955 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1950 + 127i)) << bitcast<u32>(23i)))));
let _e2040 = (_e1414.member_6.z * ((1f + (_e2003 * (1f + (_e2003 * (0.5f + (_e2003 * (0.16666667f + (_e2003 * (0.041666668f + (_e2003 * (0.008333334f + (_e2003 * (0.001388889f + (_e2003 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1998 + 127i)) << bitcast<u32>(23i)))));
let _e2069 = type_25(_e1414.member, _e1414.member_1, _e1414.member_2, _e1414.member_3, _e1414.member_4, _e1414.member_5, vec3<f32>(_e2034, _e2037, _e2040), _e1414.member_7, _e1414.member_8, _e1414.member_9, _e1414.member_10, _e1414.member_11, _e1414.member_12, _e1414.member_13, _e1414.member_14, _e1414.member_15, _e1414.member_16, _e1414.member_17, _e1414.member_18, _e1414.member_19, _e1414.member_20, _e1414.member_21, _e1414.member_22, _e1414.member_23, _e1414.member_24, _e1414.member_25, _e1414.member_26, _e1414.member_27);
if _e1458 {
phi_4293_ = ((((_e1414.member_6.x + _e1414.member_6.y) + _e1414.member_6.z) * _e2030) - (((_e2034 + _e2037) + _e2040) * _e2030));
} else {
phi_4293_ = 0f;
}
let _e2075 = phi_4293_;
phi_4583_ = type_25(_e2069.member, _e2069.member_1, _e2069.member_2, _e2069.member_3, _e2069.member_4, _e2069.member_5, _e2069.member_6, _e2069.member_7, _e2069.member_8, _e2069.member_9, _e2069.member_10, _e2069.member_11, _e2069.member_12, _e2069.member_13, _e2069.member_14, _e2069.member_15, _e2069.member_16, _e2069.member_17, _e2069.member_18, _e2069.member_19, _e2069.member_20, _e2069.member_21, _e2069.member_22, _e2069.member_23, _e2069.member_24, _e2069.member_25, (_e1414.member_26 + _e2075), _e2069.member_27);
} else {
let _e1531 = select(1e6f, _e1468, (_e1468 < 1e6f));
let _e1533 = local_1;
let _e1534 = (_e1533 * 4i);
let _e1535 = (_e1534 + 1i);
let _e1537 = select(_e1491, _e1535, (_e1535 < _e1491));
let _e1543 = global_3.member[bitcast<u32>(select(0i, _e1537, (_e1537 > 0i)))];
let _e1545 = -((_e1543 * _e1531));
let _e1547 = select(-87f, _e1545, (_e1545 > -87f));
let _e1549 = select(88f, _e1547, (_e1547 < 88f));
let _e1551 = ((_e1549 * 1.442695f) + 0.5f);
let _e1553 = select(-127f, _e1551, (_e1551 > -127f));
let _e1555 = select(128f, _e1553, (_e1553 < 128f));
let _e1562 = select(0i, select(select(i32(_e1555), i32(-2147483648), (_e1555 < -2147483600f)), 2147483647i, (_e1555 > 2147483500f)), (_e1555 == _e1555));
let _e1566 = (_e1562 - select(0i, 1i, (_e1555 < f32(_e1562))));
let _e1567 = f32(_e1566);
let _e1571 = ((_e1549 - (_e1567 * 0.6933594f)) - (_e1567 * -2.1219444e-4f));
let _e1592 = (_e1534 + 2i);
let _e1594 = select(_e1491, _e1592, (_e1592 < _e1491));
let _e1600 = global_3.member[bitcast<u32>(select(0i, _e1594, (_e1594 > 0i)))];
let _e1602 = -((_e1600 * _e1531));
let _e1604 = select(-87f, _e1602, (_e1602 > -87f));
let _e1606 = select(88f, _e1604, (_e1604 < 88f));
let _e1608 = ((_e1606 * 1.442695f) + 0.5f);
let _e1610 = select(-127f, _e1608, (_e1608 > -127f));
let _e1612 = select(128f, _e1610, (_e1610 < 128f));
let _e1619 = select(0i, select(select(i32(_e1612), i32(-2147483648), (_e1612 < -2147483600f)), 2147483647i, (_e1612 > 2147483500f)), (_e1612 == _e1612));
let _e1623 = (_e1619 - select(0i, 1i, (_e1612 < f32(_e1619))));
let _e1624 = f32(_e1623);
let _e1628 = ((_e1606 - (_e1624 * 0.6933594f)) - (_e1624 * -2.1219444e-4f));
let _e1649 = (_e1534 + 3i);
let _e1651 = select(_e1491, _e1649, (_e1649 < _e1491));
let _e1657 = global_3.member[bitcast<u32>(select(0i, _e1651, (_e1651 > 0i)))];
let _e1659 = -((_e1657 * _e1531));
let _e1661 = select(-87f, _e1659, (_e1659 > -87f));
let _e1663 = select(88f, _e1661, (_e1661 < 88f));
let _e1665 = ((_e1663 * 1.442695f) + 0.5f);
let _e1667 = select(-127f, _e1665, (_e1665 > -127f));
let _e1669 = select(128f, _e1667, (_e1667 < 128f));
let _e1676 = select(0i, select(select(i32(_e1669), i32(-2147483648), (_e1669 < -2147483600f)), 2147483647i, (_e1669 > 2147483500f)), (_e1669 == _e1669));
let _e1680 = (_e1676 - select(0i, 1i, (_e1669 < f32(_e1676))));
let _e1681 = f32(_e1680);
let _e1685 = ((_e1663 - (_e1681 * 0.6933594f)) - (_e1681 * -2.1219444e-4f));
let _e1712 = (1f / 3f);
let _e1716 = (_e1414.member_6.x * ((1f + (_e1571 * (1f + (_e1571 * (0.5f + (_e1571 * (0.16666667f + (_e1571 * (0.041666668f + (_e1571 * (0.008333334f + (_e1571 * (0.001388889f + (_e1571 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1566 + 127i)) << bitcast<u32>(23i)))));
let _e1719 = (_e1414.member_6.y * ((1f + (_e1628 * (1f + (_e1628 * (0.5f + (_e1628 * (0.16666667f + (_e1628 * (0.041666668f + (_e1628 * (0.008333334f + (_e1628 * (0.001388889f + (_e1628 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1623 + 127i)) << bitcast<u32>(23i)))));
let _e1722 = (_e1414.member_6.z * ((1f + (_e1685 * (1f + (_e1685 * (0.5f + (_e1685 * (0.16666667f + (_e1685 * (0.041666668f + (_e1685 * (0.008333334f + (_e1685 * (0.001388889f + (_e1685 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1680 + 127i)) << bitcast<u32>(23i)))));
let _e1751 = type_25(_e1414.member, _e1414.member_1, _e1414.member_2, _e1414.member_3, _e1414.member_4, _e1414.member_5, vec3<f32>(_e1716, _e1719, _e1722), _e1414.member_7, _e1414.member_8, _e1414.member_9, _e1414.member_10, _e1414.member_11, _e1414.member_12, _e1414.member_13, _e1414.member_14, _e1414.member_15, _e1414.member_16, _e1414.member_17, _e1414.member_18, _e1414.member_19, _e1414.member_20, _e1414.member_21, _e1414.member_22, _e1414.member_23, _e1414.member_24, _e1414.member_25, _e1414.member_26, _e1414.member_27);
if _e1458 {
phi_4579_ = ((((_e1414.member_6.x + _e1414.member_6.y) + _e1414.member_6.z) * _e1712) - (((_e1716 + _e1719) + _e1722) * _e1712));
} else {
phi_4579_ = 0f;
}
let _e1757 = phi_4579_;
phi_4583_ = type_25(_e1751.member, _e1751.member_1, _e1751.member_2, _e1751.member_3, _e1751.member_4, _e1751.member_5, _e1751.member_6, _e1751.member_7, _e1751.member_8, _e1751.member_9, _e1751.member_10, _e1751.member_11, _e1751.member_12, _e1751.member_13, _e1751.member_14, _e1751.member_15, _e1751.member_16, _e1751.member_17, _e1751.member_18, _e1751.member_19, _e1751.member_20, _e1751.member_21, _e1751.member_22, _e1751.member_23, _e1751.member_24, (_e1414.member_25 + _e1757), _e1751.member_26, _e1751.member_27);
}
let _e2107 = phi_4583_;
if (!(_e1463) || (_e1503 && (_e1501 == 0f))) {
if (bitcast<i32>(countOneBits(bitcast<u32>((_e2107.member_17 & ((1i << bitcast<u32>((_e2107.member_16 & 31i))) - 1i))))) == _e2107.member_20) {
phi_4637_ = (((_e2107.member_6.x + _e2107.member_6.y) + _e2107.member_6.z) * (1f / 3f));
} else {
phi_4637_ = 0f;
}
let _e5825 = phi_4637_;
if (_e2107.member_9 == -1i) {
phi_4649_ = type_25(_e2107.member, _e2107.member_1, _e2107.member_2, _e2107.member_3, _e2107.member_4, _e2107.member_5, _e2107.member_6, _e2107.member_7, _e2107.member_8, _e2107.member_9, _e2107.member_10, _e2107.member_11, _e2107.member_12, _e2107.member_13, _e2107.member_14, _e2107.member_15, _e2107.member_16, _e2107.member_17, _e2107.member_18, _e2107.member_19, _e2107.member_20, _e2107.member_21, _e2107.member_22, (_e2107.member_23 + _e5825), _e2107.member_24, _e2107.member_25, _e2107.member_26, _e2107.member_27);
} else {
phi_4649_ = type_25(_e2107.member, _e2107.member_1, _e2107.member_2, _e2107.member_3, _e2107.member_4, _e2107.member_5, _e2107.member_6, _e2107.member_7, _e2107.member_8, _e2107.member_9, _e2107.member_10, _e2107.member_11, _e2107.member_12, _e2107.member_13, _e2107.member_14, _e2107.member_15, _e2107.member_16, _e2107.member_17, _e2107.member_18, _e2107.member_19, _e2107.member_20, _e2107.member_21, _e2107.member_22, _e2107.member_23, (_e2107.member_24 + _e5825), _e2107.member_25, _e2107.member_26, _e2107.member_27);
}
let _e5889 = phi_4649_;
let _e5891 = (_e5889.member_18 == 0i);
if (_e5891 && (_e5889.member_21 == 0i)) {
phi_5949_ = type_25(_e5889.member, _e5889.member_1, _e5889.member_2, _e5889.member_3, _e5889.member_4, _e5889.member_5, _e5889.member_6, _e5889.member_7, _e5889.member_8, _e5889.member_9, _e5889.member_10, _e5889.member_11, _e5889.member_12, _e5889.member_13, _e5889.member_14, 3f, _e5889.member_16, _e5889.member_17, _e5889.member_18, _e5889.member_19, _e5889.member_20, _e5889.member_21, _e5889.member_22, _e5889.member_23, _e5889.member_24, _e5889.member_25, _e5889.member_26, _e5889.member_27);
} else {
if _e5891 {
let _e6023 = type_25(_e5889.member, _e5889.member_1, _e5889.member_2, _e5889.member_3, _e5889.member_4, _e5889.member_5, _e5889.member_6, _e5889.member_7, _e5889.member_8, _e5889.member_9, _e5889.member_10, _e5889.member_11, _e5889.member_12, _e5889.member_13, _e5889.member_14, _e5889.member_15, _e5889.member_16, _e5889.member_17, _e5889.member_18, _e5889.member_19, (_e5889.member_20 + 1i), _e5889.member_21, _e5889.member_22, _e5889.member_23, _e5889.member_24, _e5889.member_25, _e5889.member_26, _e5889.member_27);
let _e6051 = type_25(_e6023.member, _e6023.member_1, _e6023.member_2, _e6023.member_3, _e6023.member_4, _e6023.member_5, _e6023.member_6, _e6023.member_7, _e6023.member_8, _e6023.member_9, _e6023.member_10, _e6023.member_11, _e6023.member_12, _e6023.member_13, _e6023.member_14, _e6023.member_15, _e6023.member_16, _e6023.member_17, _e6023.member_18, _e6023.member_19, _e6023.member_20, 0i, _e6023.member_22, _e6023.member_23, _e6023.member_24, _e6023.member_25, _e6023.member_26, _e6023.member_27);
let _e6079 = type_25(_e6051.member, _e6051.member_1, _e6051.member_2, _e6051.member_3, _e6051.member_4, _e6051.member_5, _e6051.member_6, _e6051.member_7, _e6051.member_8, _e6051.member_9, _e6051.member_10, _e6051.member_11, _e6051.member_12, _e6051.member_13, _e6051.member_14, _e6051.member_15, _e6051.member_16, 0i, _e6051.member_18, _e6051.member_19, _e6051.member_20, _e6051.member_21, _e6051.member_22, _e6051.member_23, _e6051.member_24, _e6051.member_25, _e6051.member_26, _e6051.member_27);
phi_4690_ = type_25(_e6079.member, _e6079.member_1, _e6079.member_2, _e6079.member_3, _e6079.member_4, _e6079.member_5, _e6079.member_6, _e6079.member_7, _e6079.member_8, _e6079.member_9, _e6079.member_10, _e6079.member_11, _e6079.member_12, _e6079.member_13, _e6079.member_14, _e6079.member_15, _e6079.member_16, _e6079.member_17, _e6079.member_18, 0i, _e6079.member_20, _e6079.member_21, _e6079.member_22, _e6079.member_23, _e6079.member_24, _e6079.member_25, _e6079.member_26, _e6079.member_27);
} else {
let _e5899 = bitcast<i32>((bitcast<u32>(f32(_e5889.member_18)) >> bitcast<u32>(23i)));
let _e5903 = (1i << bitcast<u32>(((_e5899 - 127i) & 31i)));
let _e5904 = (_e5903 - 1i);
let _e5935 = type_25(_e5889.member, _e5889.member_1, _e5889.member_2, _e5889.member_3, _e5889.member_4, _e5889.member_5, _e5889.member_6, _e5889.member_7, _e5889.member_8, _e5889.member_9, _e5889.member_10, _e5889.member_11, _e5889.member_12, _e5889.member_13, _e5889.member_14, _e5889.member_15, _e5889.member_16, ((_e5889.member_17 & _e5904) | _e5903), _e5889.member_18, _e5889.member_19, _e5889.member_20, _e5889.member_21, _e5889.member_22, _e5889.member_23, _e5889.member_24, _e5889.member_25, _e5889.member_26, _e5889.member_27);
let _e5964 = type_25(_e5935.member, _e5935.member_1, _e5935.member_2, _e5935.member_3, _e5935.member_4, _e5935.member_5, _e5935.member_6, _e5935.member_7, _e5935.member_8, _e5935.member_9, _e5935.member_10, _e5935.member_11, _e5935.member_12, _e5935.member_13, _e5935.member_14, _e5935.member_15, _e5935.member_16, _e5935.member_17, (_e5889.member_18 & _e5904), _e5935.member_19, _e5935.member_20, _e5935.member_21, _e5935.member_22, _e5935.member_23, _e5935.member_24, _e5935.member_25, _e5935.member_26, _e5935.member_27);
phi_4690_ = type_25(_e5964.member, _e5964.member_1, _e5964.member_2, _e5964.member_3, _e5964.member_4, _e5964.member_5, _e5964.member_6, _e5964.member_7, _e5964.member_8, _e5964.member_9, _e5964.member_10, _e5964.member_11, _e5964.member_12, _e5964.member_13, _e5964.member_14, _e5964.member_15, _e5964.member_16, _e5964.member_17, _e5964.member_18, (_e5899 + -126i), _e5964.member_20, _e5964.member_21, _e5964.member_22, _e5964.member_23, _e5964.member_24, _e5964.member_25, _e5964.member_26, _e5964.member_27);
}
let _e6109 = phi_4690_;
let _e6115 = global_5.member.member_1.member;
let _e6117 = f32(bitcast<i32>(_e6115));
let _e6121 = global_5.member.member_1.member_1;
let _e6123 = f32(bitcast<i32>(_e6121));
let _e6133 = global_5.member.member_2.member;
let _e6134 = (((((f32(bitcast<i32>(_e121.x)) + 0.5f) / _e6117) * 2f) - 1f) * _e6133);
let _e6142 = global_5.member.member_2.member_1;
let _e6143 = ((1f - (((f32(bitcast<i32>(_e121.y)) + 0.5f) / _e6123) * 2f)) * _e6142);
let _e6146 = global_5.member.member_3;
let _e6155 = global_5.member.member_4;
let _e6162 = ((_e6146.member * _e6134) + (_e6155.member * _e6143));
let _e6163 = ((_e6146.member_1 * _e6134) + (_e6155.member_1 * _e6143));
let _e6164 = ((_e6146.member_2 * _e6134) + (_e6155.member_2 * _e6143));
let _e6168 = global_5.member.member_2.member_3;
let _e6169 = (_e6168 != 0u);
let _e6172 = global_5.member.member_5;
let _e6179 = select((_e6172.member + _e6162), _e6172.member, _e6169);
let _e6180 = select((_e6172.member_1 + _e6163), _e6172.member_1, _e6169);
let _e6181 = select((_e6172.member_2 + _e6164), _e6172.member_2, _e6169);
let _e6184 = global_5.member.member_6;
let _e6191 = select(_e6184.member, (_e6184.member + _e6162), _e6169);
let _e6192 = select(_e6184.member_1, (_e6184.member_1 + _e6163), _e6169);
let _e6193 = select(_e6184.member_2, (_e6184.member_2 + _e6164), _e6169);
let _e6199 = (((_e6179 * _e6179) + (_e6180 * _e6180)) + (_e6181 * _e6181));
let _e6203 = (1f / sqrt(select(0f, _e6199, (_e6199 > 0f))));
let _e6204 = (_e6179 * _e6203);
let _e6205 = (_e6180 * _e6203);
let _e6206 = (_e6181 * _e6203);
let _e6209 = ((2f * _e6133) / _e6117);
let _e6210 = (_e6146.member * _e6209);
let _e6211 = (_e6146.member_1 * _e6209);
let _e6212 = (_e6146.member_2 * _e6209);
let _e6214 = ((-2f * _e6142) / _e6123);
let _e6215 = (_e6155.member * _e6214);
let _e6216 = (_e6155.member_1 * _e6214);
let _e6217 = (_e6155.member_2 * _e6214);
let _e6230 = (((_e6210 * _e6204) + (_e6211 * _e6205)) + (_e6212 * _e6206));
let _e6240 = select(((_e6210 - (_e6204 * _e6230)) * _e6203), 0f, _e6169);
let _e6241 = select(((_e6211 - (_e6205 * _e6230)) * _e6203), 0f, _e6169);
let _e6242 = select(((_e6212 - (_e6206 * _e6230)) * _e6203), 0f, _e6169);
let _e6248 = (((_e6215 * _e6204) + (_e6216 * _e6205)) + (_e6217 * _e6206));
let _e6258 = select(((_e6215 - (_e6204 * _e6248)) * _e6203), 0f, _e6169);
let _e6259 = select(((_e6216 - (_e6205 * _e6248)) * _e6203), 0f, _e6169);
let _e6260 = select(((_e6217 - (_e6206 * _e6248)) * _e6203), 0f, _e6169);
let _e6269 = (1f / select(_e6204, select(1e-12f, -1e-12f, (_e6204 < 0f)), (bitcast<f32>((bitcast<u32>(_e6204) & 2147483647u)) < 1e-12f)));
let _e6277 = (1f / select(_e6205, select(1e-12f, -1e-12f, (_e6205 < 0f)), (bitcast<f32>((bitcast<u32>(_e6205) & 2147483647u)) < 1e-12f)));
let _e6285 = (1f / select(_e6206, select(1e-12f, -1e-12f, (_e6206 < 0f)), (bitcast<f32>((bitcast<u32>(_e6206) & 2147483647u)) < 1e-12f)));
let _e6288 = global_5.member.member_8;
let _e6294 = global_5.member.member_9;
let _e6299 = ((_e6288.member - _e6191) * _e6269);
let _e6301 = ((_e6294.member - _e6191) * _e6269);
let _e6303 = ((_e6288.member_1 - _e6192) * _e6277);
let _e6305 = ((_e6294.member_1 - _e6192) * _e6277);
let _e6307 = ((_e6288.member_2 - _e6193) * _e6285);
let _e6309 = ((_e6294.member_2 - _e6193) * _e6285);
let _e6311 = select(_e6301, _e6299, (_e6299 < _e6301));
let _e6313 = select(_e6305, _e6303, (_e6303 < _e6305));
let _e6315 = select(_e6313, _e6311, (_e6311 > _e6313));
let _e6317 = select(_e6309, _e6307, (_e6307 < _e6309));
let _e6319 = select(_e6317, _e6315, (_e6315 > _e6317));
let _e6321 = select(_e6301, _e6299, (_e6299 > _e6301));
let _e6323 = select(_e6305, _e6303, (_e6303 > _e6305));
let _e6325 = select(_e6323, _e6321, (_e6321 < _e6323));
let _e6327 = select(_e6309, _e6307, (_e6307 > _e6309));
let _e6331 = select(0f, _e6319, (_e6319 > 0f));
let _e6336 = global_5.member.member_14.member.member;
let _e6347 = ((((_e6336.member.member * _e6191) + (_e6336.member.member_1 * _e6192)) + (_e6336.member.member_2 * _e6193)) + _e6336.member_1);
let _e6353 = -((((_e6336.member.member * _e6204) + (_e6336.member.member_1 * _e6205)) + (_e6336.member.member_2 * _e6206)));
let _e6355 = (_e6353 > 1e-9f);
let _e6357 = select(1e-9f, _e6353, _e6355);
let _e6359 = ((_e6347 / _e6357) - 0.015625f);
let _e6362 = select(1e30f, select(0f, _e6359, (_e6359 > 0f)), ((_e6347 > 0f) && _e6355));
let _e6367 = global_5.member.member_14.member_1.member;
let _e6378 = ((((_e6367.member.member * _e6191) + (_e6367.member.member_1 * _e6192)) + (_e6367.member.member_2 * _e6193)) + _e6367.member_1);
let _e6384 = -((((_e6367.member.member * _e6204) + (_e6367.member.member_1 * _e6205)) + (_e6367.member.member_2 * _e6206)));
let _e6386 = (_e6384 > 1e-9f);
let _e6388 = select(1e-9f, _e6384, _e6386);
let _e6390 = ((_e6378 / _e6388) - 0.015625f);
let _e6393 = select(1e30f, select(0f, _e6390, (_e6390 > 0f)), ((_e6378 > 0f) && _e6386));
let _e6399 = ((select(_e6327, _e6325, (_e6325 < _e6327)) <= _e6331) || (true && (select(_e6362, _e6393, (_e6393 < _e6362)) <= _e6331)));
let _e6400 = select(_e6331, 0f, _e6399);
let _e6401 = (_e6204 * _e6400);
let _e6402 = (_e6205 * _e6400);
let _e6403 = (_e6206 * _e6400);
let _e6404 = (_e6191 + _e6401);
let _e6405 = (_e6192 + _e6402);
let _e6406 = (_e6193 + _e6403);
let _e6436 = type_25((vec3<f32>(_e6191, _e6192, _e6193) + vec3<f32>(_e6401, _e6402, _e6403)), _e6109.member_1, _e6109.member_2, _e6109.member_3, _e6109.member_4, _e6109.member_5, _e6109.member_6, _e6109.member_7, _e6109.member_8, _e6109.member_9, _e6109.member_10, _e6109.member_11, _e6109.member_12, _e6109.member_13, _e6109.member_14, _e6109.member_15, _e6109.member_16, _e6109.member_17, _e6109.member_18, _e6109.member_19, _e6109.member_20, _e6109.member_21, _e6109.member_22, _e6109.member_23, _e6109.member_24, _e6109.member_25, _e6109.member_26, _e6109.member_27);
let _e6464 = type_25(_e6436.member, vec3<f32>(_e6204, _e6205, _e6206), _e6436.member_2, _e6436.member_3, _e6436.member_4, _e6436.member_5, _e6436.member_6, _e6436.member_7, _e6436.member_8, _e6436.member_9, _e6436.member_10, _e6436.member_11, _e6436.member_12, _e6436.member_13, _e6436.member_14, _e6436.member_15, _e6436.member_16, _e6436.member_17, _e6436.member_18, _e6436.member_19, _e6436.member_20, _e6436.member_21, _e6436.member_22, _e6436.member_23, _e6436.member_24, _e6436.member_25, _e6436.member_26, _e6436.member_27);
let _e6502 = type_25(_e6464.member, _e6464.member_1, (vec3<f32>(select(0f, _e6210, _e6169), select(0f, _e6211, _e6169), select(0f, _e6212, _e6169)) + vec3<f32>((_e6240 * _e6400), (_e6241 * _e6400), (_e6242 * _e6400))), _e6464.member_3, _e6464.member_4, _e6464.member_5, _e6464.member_6, _e6464.member_7, _e6464.member_8, _e6464.member_9, _e6464.member_10, _e6464.member_11, _e6464.member_12, _e6464.member_13, _e6464.member_14, _e6464.member_15, _e6464.member_16, _e6464.member_17, _e6464.member_18, _e6464.member_19, _e6464.member_20, _e6464.member_21, _e6464.member_22, _e6464.member_23, _e6464.member_24, _e6464.member_25, _e6464.member_26, _e6464.member_27);
let _e6530 = type_25(_e6502.member, _e6502.member_1, _e6502.member_2, (vec3<f32>(select(0f, _e6215, _e6169), select(0f, _e6216, _e6169), select(0f, _e6217, _e6169)) + vec3<f32>((_e6258 * _e6400), (_e6259 * _e6400), (_e6260 * _e6400))), _e6502.member_4, _e6502.member_5, _e6502.member_6, _e6502.member_7, _e6502.member_8, _e6502.member_9, _e6502.member_10, _e6502.member_11, _e6502.member_12, _e6502.member_13, _e6502.member_14, _e6502.member_15, _e6502.member_16, _e6502.member_17, _e6502.member_18, _e6502.member_19, _e6502.member_20, _e6502.member_21, _e6502.member_22, _e6502.member_23, _e6502.member_24, _e6502.member_25, _e6502.member_26, _e6502.member_27);
let _e6558 = type_25(_e6530.member, _e6530.member_1, _e6530.member_2, _e6530.member_3, vec3<f32>(_e6240, _e6241, _e6242), _e6530.member_5, _e6530.member_6, _e6530.member_7, _e6530.member_8, _e6530.member_9, _e6530.member_10, _e6530.member_11, _e6530.member_12, _e6530.member_13, _e6530.member_14, _e6530.member_15, _e6530.member_16, _e6530.member_17, _e6530.member_18, _e6530.member_19, _e6530.member_20, _e6530.member_21, _e6530.member_22, _e6530.member_23, _e6530.member_24, _e6530.member_25, _e6530.member_26, _e6530.member_27);
let _e6586 = type_25(_e6558.member, _e6558.member_1, _e6558.member_2, _e6558.member_3, _e6558.member_4, vec3<f32>(_e6258, _e6259, _e6260), _e6558.member_6, _e6558.member_7, _e6558.member_8, _e6558.member_9, _e6558.member_10, _e6558.member_11, _e6558.member_12, _e6558.member_13, _e6558.member_14, _e6558.member_15, _e6558.member_16, _e6558.member_17, _e6558.member_18, _e6558.member_19, _e6558.member_20, _e6558.member_21, _e6558.member_22, _e6558.member_23, _e6558.member_24, _e6558.member_25, _e6558.member_26, _e6558.member_27);
let _e6614 = type_25(_e6586.member, _e6586.member_1, _e6586.member_2, _e6586.member_3, _e6586.member_4, _e6586.member_5, _e6586.member_6, 0i, _e6586.member_8, _e6586.member_9, _e6586.member_10, _e6586.member_11, _e6586.member_12, _e6586.member_13, _e6586.member_14, _e6586.member_15, _e6586.member_16, _e6586.member_17, _e6586.member_18, _e6586.member_19, _e6586.member_20, _e6586.member_21, _e6586.member_22, _e6586.member_23, _e6586.member_24, _e6586.member_25, _e6586.member_26, _e6586.member_27);
let _e6642 = type_25(_e6614.member, _e6614.member_1, _e6614.member_2, _e6614.member_3, _e6614.member_4, _e6614.member_5, _e6614.member_6, _e6614.member_7, _e6614.member_8, _e6614.member_9, _e6614.member_10, _e6614.member_11, _e6614.member_12, _e6614.member_13, _e6614.member_14, _e6614.member_15, 0i, _e6614.member_17, _e6614.member_18, _e6614.member_19, _e6614.member_20, _e6614.member_21, _e6614.member_22, _e6614.member_23, _e6614.member_24, _e6614.member_25, _e6614.member_26, _e6614.member_27);
let _e6670 = type_25(_e6642.member, _e6642.member_1, _e6642.member_2, _e6642.member_3, _e6642.member_4, _e6642.member_5, _e6642.member_6, _e6642.member_7, _e6642.member_8, _e6642.member_9, _e6642.member_10, _e6642.member_11, _e6642.member_12, _e6642.member_13, _e6642.member_14, 1f, _e6642.member_16, _e6642.member_17, _e6642.member_18, _e6642.member_19, _e6642.member_20, _e6642.member_21, _e6642.member_22, _e6642.member_23, _e6642.member_24, _e6642.member_25, _e6642.member_26, _e6642.member_27);
let _e6676 = ((((_e6336.member.member * _e6404) + (_e6336.member.member_1 * _e6405)) + (_e6336.member.member_2 * _e6406)) + _e6336.member_1);
let _e6680 = ((_e6676 / _e6357) - 0.015625f);
let _e6683 = select(1e30f, select(0f, _e6680, (_e6680 > 0f)), ((_e6676 > 0f) && _e6355));
let _e6689 = ((((_e6367.member.member * _e6404) + (_e6367.member.member_1 * _e6405)) + (_e6367.member.member_2 * _e6406)) + _e6367.member_1);
let _e6693 = ((_e6689 / _e6388) - 0.015625f);
let _e6696 = select(1e30f, select(0f, _e6693, (_e6693 > 0f)), ((_e6689 > 0f) && _e6386));
let _e6700 = (_e6696 < _e6683);
let _e6731 = type_25(_e6670.member, _e6670.member_1, _e6670.member_2, _e6670.member_3, _e6670.member_4, _e6670.member_5, _e6670.member_6, _e6670.member_7, 0i, _e6670.member_9, _e6670.member_10, _e6670.member_11, _e6670.member_12, _e6670.member_13, _e6670.member_14, _e6670.member_15, _e6670.member_16, _e6670.member_17, _e6670.member_18, _e6670.member_19, _e6670.member_20, _e6670.member_21, _e6670.member_22, _e6670.member_23, _e6670.member_24, _e6670.member_25, _e6670.member_26, _e6670.member_27);
let _e6759 = type_25(_e6731.member, _e6731.member_1, _e6731.member_2, _e6731.member_3, _e6731.member_4, _e6731.member_5, _e6731.member_6, _e6731.member_7, _e6731.member_8, select(select(-2i, -3i, _e6700), -1i, ((_e6683 >= 1e30f) && (_e6696 >= 1e30f))), _e6731.member_10, _e6731.member_11, _e6731.member_12, _e6731.member_13, _e6731.member_14, _e6731.member_15, _e6731.member_16, _e6731.member_17, _e6731.member_18, _e6731.member_19, _e6731.member_20, _e6731.member_21, _e6731.member_22, _e6731.member_23, _e6731.member_24, _e6731.member_25, _e6731.member_26, _e6731.member_27);
let _e6787 = type_25(_e6759.member, _e6759.member_1, _e6759.member_2, _e6759.member_3, _e6759.member_4, _e6759.member_5, _e6759.member_6, _e6759.member_7, _e6759.member_8, _e6759.member_9, select(_e6683, _e6696, _e6700), _e6759.member_11, _e6759.member_12, _e6759.member_13, _e6759.member_14, _e6759.member_15, _e6759.member_16, _e6759.member_17, _e6759.member_18, _e6759.member_19, _e6759.member_20, _e6759.member_21, _e6759.member_22, _e6759.member_23, _e6759.member_24, _e6759.member_25, _e6759.member_26, _e6759.member_27);
let _e6815 = type_25(_e6787.member, _e6787.member_1, _e6787.member_2, _e6787.member_3, _e6787.member_4, _e6787.member_5, _e6787.member_6, _e6787.member_7, _e6787.member_8, _e6787.member_9, _e6787.member_10, _e6787.member_11, _e6787.member_12, 0f, _e6787.member_14, _e6787.member_15, _e6787.member_16, _e6787.member_17, _e6787.member_18, _e6787.member_19, _e6787.member_20, _e6787.member_21, _e6787.member_22, _e6787.member_23, _e6787.member_24, _e6787.member_25, _e6787.member_26, _e6787.member_27);
let _e6843 = type_25(_e6815.member, _e6815.member_1, _e6815.member_2, _e6815.member_3, _e6815.member_4, _e6815.member_5, _e6815.member_6, _e6815.member_7, _e6815.member_8, _e6815.member_9, _e6815.member_10, 0i, _e6815.member_12, _e6815.member_13, _e6815.member_14, _e6815.member_15, _e6815.member_16, _e6815.member_17, _e6815.member_18, _e6815.member_19, _e6815.member_20, _e6815.member_21, _e6815.member_22, _e6815.member_23, _e6815.member_24, _e6815.member_25, _e6815.member_26, _e6815.member_27);
let _e6871 = type_25(_e6843.member, _e6843.member_1, _e6843.member_2, _e6843.member_3, _e6843.member_4, _e6843.member_5, _e6843.member_6, _e6843.member_7, _e6843.member_8, _e6843.member_9, _e6843.member_10, _e6843.member_11, 0i, _e6843.member_13, _e6843.member_14, _e6843.member_15, _e6843.member_16, _e6843.member_17, _e6843.member_18, _e6843.member_19, _e6843.member_20, _e6843.member_21, _e6843.member_22, _e6843.member_23, _e6843.member_24, _e6843.member_25, _e6843.member_26, _e6843.member_27);
let _e6875 = global_5.member.member_13.member_4;
let _e6882 = global_5.member.member_13.member_5;
let _e6887 = ((_e6875.member - _e6191) * _e6269);
let _e6889 = ((_e6882.member - _e6191) * _e6269);
let _e6891 = ((_e6875.member_1 - _e6192) * _e6277);
let _e6893 = ((_e6882.member_1 - _e6192) * _e6277);
let _e6895 = ((_e6875.member_2 - _e6193) * _e6285);
let _e6897 = ((_e6882.member_2 - _e6193) * _e6285);
let _e6899 = select(_e6889, _e6887, (_e6887 < _e6889));
let _e6901 = select(_e6893, _e6891, (_e6891 < _e6893));
let _e6903 = select(_e6901, _e6899, (_e6899 > _e6901));
let _e6905 = select(_e6897, _e6895, (_e6895 < _e6897));
let _e6907 = select(_e6905, _e6903, (_e6903 > _e6905));
let _e6909 = select(_e6889, _e6887, (_e6887 > _e6889));
let _e6911 = select(_e6893, _e6891, (_e6891 > _e6893));
let _e6913 = select(_e6911, _e6909, (_e6909 < _e6911));
let _e6915 = select(_e6897, _e6895, (_e6895 > _e6897));
let _e6917 = select(_e6915, _e6913, (_e6913 < _e6915));
let _e6919 = select(0f, _e6907, (_e6907 > 0f));
let _e6921 = select(_e6400, _e6917, (_e6917 < _e6400));
let _e6924 = (select(_e6919, _e6921, (_e6921 > _e6919)) - _e6919);
let _e6928 = global_5.member.member_13.member;
let _e6933 = -((_e6928.member * _e6924));
let _e6935 = select(-87f, _e6933, (_e6933 > -87f));
let _e6937 = select(88f, _e6935, (_e6935 < 88f));
let _e6939 = ((_e6937 * 1.442695f) + 0.5f);
let _e6941 = select(-127f, _e6939, (_e6939 > -127f));
let _e6943 = select(128f, _e6941, (_e6941 < 128f));
let _e6950 = select(0i, select(select(i32(_e6943), i32(-2147483648), (_e6943 < -2147483600f)), 2147483647i, (_e6943 > 2147483500f)), (_e6943 == _e6943));
let _e6954 = (_e6950 - select(0i, 1i, (_e6943 < f32(_e6950))));
let _e6955 = f32(_e6954);
let _e6959 = ((_e6937 - (_e6955 * 0.6933594f)) - (_e6955 * -2.1219444e-4f));
let _e6981 = -((_e6928.member_1 * _e6924));
let _e6983 = select(-87f, _e6981, (_e6981 > -87f));
let _e6985 = select(88f, _e6983, (_e6983 < 88f));
let _e6987 = ((_e6985 * 1.442695f) + 0.5f);
let _e6989 = select(-127f, _e6987, (_e6987 > -127f));
let _e6991 = select(128f, _e6989, (_e6989 < 128f));
let _e6998 = select(0i, select(select(i32(_e6991), i32(-2147483648), (_e6991 < -2147483600f)), 2147483647i, (_e6991 > 2147483500f)), (_e6991 == _e6991));
let _e7002 = (_e6998 - select(0i, 1i, (_e6991 < f32(_e6998))));
let _e7003 = f32(_e7002);
let _e7007 = ((_e6985 - (_e7003 * 0.6933594f)) - (_e7003 * -2.1219444e-4f));
let _e7029 = -((_e6928.member_2 * _e6924));
let _e7031 = select(-87f, _e7029, (_e7029 > -87f));
let _e7033 = select(88f, _e7031, (_e7031 < 88f));
let _e7035 = ((_e7033 * 1.442695f) + 0.5f);
let _e7037 = select(-127f, _e7035, (_e7035 > -127f));
let _e7039 = select(128f, _e7037, (_e7037 < 128f));
let _e7046 = select(0i, select(select(i32(_e7039), i32(-2147483648), (_e7039 < -2147483600f)), 2147483647i, (_e7039 > 2147483500f)), (_e7039 == _e7039));
let _e7050 = (_e7046 - select(0i, 1i, (_e7039 < f32(_e7046))));
let _e7051 = f32(_e7050);
let _e7055 = ((_e7033 - (_e7051 * 0.6933594f)) - (_e7051 * -2.1219444e-4f));
let _e7078 = (1f / 3f);
let _e7080 = (1f * ((1f + (_e6959 * (1f + (_e6959 * (0.5f + (_e6959 * (0.16666667f + (_e6959 * (0.041666668f + (_e6959 * (0.008333334f + (_e6959 * (0.001388889f + (_e6959 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e6954 + 127i)) << bitcast<u32>(23i)))));
let _e7081 = (1f * ((1f + (_e7007 * (1f + (_e7007 * (0.5f + (_e7007 * (0.16666667f + (_e7007 * (0.041666668f + (_e7007 * (0.008333334f + (_e7007 * (0.001388889f + (_e7007 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e7002 + 127i)) << bitcast<u32>(23i)))));
let _e7082 = (1f * ((1f + (_e7055 * (1f + (_e7055 * (0.5f + (_e7055 * (0.16666667f + (_e7055 * (0.041666668f + (_e7055 * (0.008333334f + (_e7055 * (0.001388889f + (_e7055 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e7050 + 127i)) << bitcast<u32>(23i)))));
let _e7111 = type_25(_e6871.member, _e6871.member_1, _e6871.member_2, _e6871.member_3, _e6871.member_4, _e6871.member_5, vec3<f32>(_e7080, _e7081, _e7082), _e6871.member_7, _e6871.member_8, _e6871.member_9, _e6871.member_10, _e6871.member_11, _e6871.member_12, _e6871.member_13, _e6871.member_14, _e6871.member_15, _e6871.member_16, _e6871.member_17, _e6871.member_18, _e6871.member_19, _e6871.member_20, _e6871.member_21, _e6871.member_22, _e6871.member_23, _e6871.member_24, _e6871.member_25, _e6871.member_26, _e6871.member_27);
if (bitcast<i32>(countOneBits(0u)) == _e6109.member_20) {
phi_5921_ = ((((1f + 1f) + 1f) * _e7078) - (((_e7080 + _e7081) + _e7082) * _e7078));
} else {
phi_5921_ = 0f;
}
let _e7121 = phi_5921_;
let _e7151 = type_25(_e7111.member, _e7111.member_1, _e7111.member_2, _e7111.member_3, _e7111.member_4, _e7111.member_5, _e7111.member_6, _e7111.member_7, _e7111.member_8, _e7111.member_9, _e7111.member_10, _e7111.member_11, _e7111.member_12, _e7111.member_13, _e7111.member_14, _e7111.member_15, _e7111.member_16, _e7111.member_17, _e7111.member_18, _e7111.member_19, _e7111.member_20, _e7111.member_21, _e7111.member_22, _e7111.member_23, _e7111.member_24, _e7111.member_25, (_e6109.member_26 + _e7121), _e7111.member_27);
if _e6399 {
phi_5948_ = type_25(_e7151.member, _e7151.member_1, _e7151.member_2, _e7151.member_3, _e7151.member_4, _e7151.member_5, _e7151.member_6, _e7151.member_7, _e1380, _e7151.member_9, _e7151.member_10, _e7151.member_11, _e7151.member_12, _e7151.member_13, _e7151.member_14, _e7151.member_15, _e7151.member_16, _e7151.member_17, _e7151.member_18, _e7151.member_19, _e7151.member_20, _e7151.member_21, _e7151.member_22, _e7151.member_23, _e7151.member_24, _e7151.member_25, _e7151.member_26, _e7151.member_27);
} else {
phi_5948_ = _e7151;
}
let _e7181 = phi_5948_;
phi_5949_ = _e7181;
}
let _e7211 = phi_5949_;
phi_9402_ = _e7211;
phi_9403_ = type_25();
phi_9404_ = true;
} else {
let _e2114 = local_2;
let _e2116 = local_3;
let _e2118 = (!(_e1503) && (_e2114 == _e2116));
if _e2118 {
let _e5551 = type_25(_e2107.member, _e2107.member_1, _e2107.member_2, _e2107.member_3, _e2107.member_4, _e2107.member_5, _e2107.member_6, _e1512, _e2107.member_8, _e2107.member_9, _e2107.member_10, _e2107.member_11, _e2107.member_12, _e2107.member_13, _e2107.member_14, _e2107.member_15, _e2107.member_16, _e2107.member_17, _e2107.member_18, _e2107.member_19, _e2107.member_20, _e2107.member_21, _e2107.member_22, _e2107.member_23, _e2107.member_24, _e2107.member_25, _e2107.member_26, _e2107.member_27);
let _e5582 = type_25(_e5551.member, _e5551.member_1, _e5551.member_2, _e5551.member_3, _e5551.member_4, _e5551.member_5, _e5551.member_6, _e5551.member_7, _e5551.member_8, _e5551.member_9, _e5551.member_10, _e5551.member_11, _e5551.member_12, select(1.1754944e-38f, _e2107.member_14, (_e2107.member_14 > 1.1754944e-38f)), _e5551.member_14, _e5551.member_15, _e5551.member_16, _e5551.member_17, _e5551.member_18, _e5551.member_19, _e5551.member_20, _e5551.member_21, _e5551.member_22, _e5551.member_23, _e5551.member_24, _e5551.member_25, _e5551.member_26, _e5551.member_27);
let _e5610 = type_25(_e5582.member, _e5582.member_1, _e5582.member_2, _e5582.member_3, _e5582.member_4, _e5582.member_5, _e5582.member_6, _e5582.member_7, _e5582.member_8, _e5582.member_9, _e5582.member_10, 0i, _e5582.member_12, _e5582.member_13, _e5582.member_14, _e5582.member_15, _e5582.member_16, _e5582.member_17, _e5582.member_18, _e5582.member_19, _e5582.member_20, _e5582.member_21, _e5582.member_22, _e5582.member_23, _e5582.member_24, _e5582.member_25, _e5582.member_26, _e5582.member_27);
let _e5638 = type_25(_e5610.member, _e5610.member_1, _e5610.member_2, _e5610.member_3, _e5610.member_4, _e5610.member_5, _e5610.member_6, _e5610.member_7, _e5610.member_8, _e5610.member_9, _e5610.member_10, _e5610.member_11, 0i, _e5610.member_13, _e5610.member_14, _e5610.member_15, _e5610.member_16, _e5610.member_17, _e5610.member_18, _e5610.member_19, _e5610.member_20, _e5610.member_21, _e5610.member_22, _e5610.member_23, _e5610.member_24, _e5610.member_25, _e5610.member_26, _e5610.member_27);
let _e5645 = global_5.member.member_14.member.member;
let _e5659 = ((((_e5645.member.member * _e2107.member.x) + (_e5645.member.member_1 * _e2107.member.y)) + (_e5645.member.member_2 * _e2107.member.z)) + _e5645.member_1);
let _e5668 = -((((_e5645.member.member * _e2107.member_1.x) + (_e5645.member.member_1 * _e2107.member_1.y)) + (_e5645.member.member_2 * _e2107.member_1.z)));
let _e5670 = (_e5668 > 1e-9f);
let _e5674 = ((_e5659 / select(1e-9f, _e5668, _e5670)) - 0.015625f);
let _e5677 = select(1e30f, select(0f, _e5674, (_e5674 > 0f)), ((_e5659 > 0f) && _e5670));
let _e5682 = global_5.member.member_14.member_1.member;
let _e5693 = ((((_e5682.member.member * _e2107.member.x) + (_e5682.member.member_1 * _e2107.member.y)) + (_e5682.member.member_2 * _e2107.member.z)) + _e5682.member_1);
let _e5699 = -((((_e5682.member.member * _e2107.member_1.x) + (_e5682.member.member_1 * _e2107.member_1.y)) + (_e5682.member.member_2 * _e2107.member_1.z)));
let _e5701 = (_e5699 > 1e-9f);
let _e5705 = ((_e5693 / select(1e-9f, _e5699, _e5701)) - 0.015625f);
let _e5708 = select(1e30f, select(0f, _e5705, (_e5705 > 0f)), ((_e5693 > 0f) && _e5701));
let _e5712 = (_e5708 < _e5677);
let _e5743 = type_25(_e5638.member, _e5638.member_1, _e5638.member_2, _e5638.member_3, _e5638.member_4, _e5638.member_5, _e5638.member_6, _e5638.member_7, 0i, _e5638.member_9, _e5638.member_10, _e5638.member_11, _e5638.member_12, _e5638.member_13, _e5638.member_14, _e5638.member_15, _e5638.member_16, _e5638.member_17, _e5638.member_18, _e5638.member_19, _e5638.member_20, _e5638.member_21, _e5638.member_22, _e5638.member_23, _e5638.member_24, _e5638.member_25, _e5638.member_26, _e5638.member_27);
let _e5771 = type_25(_e5743.member, _e5743.member_1, _e5743.member_2, _e5743.member_3, _e5743.member_4, _e5743.member_5, _e5743.member_6, _e5743.member_7, _e5743.member_8, select(select(-2i, -3i, _e5712), -1i, ((_e5677 >= 1e30f) && (_e5708 >= 1e30f))), _e5743.member_10, _e5743.member_11, _e5743.member_12, _e5743.member_13, _e5743.member_14, _e5743.member_15, _e5743.member_16, _e5743.member_17, _e5743.member_18, _e5743.member_19, _e5743.member_20, _e5743.member_21, _e5743.member_22, _e5743.member_23, _e5743.member_24, _e5743.member_25, _e5743.member_26, _e5743.member_27);
phi_9400_ = type_25(_e5771.member, _e5771.member_1, _e5771.member_2, _e5771.member_3, _e5771.member_4, _e5771.member_5, _e5771.member_6, _e5771.member_7, _e5771.member_8, _e5771.member_9, select(_e5677, _e5708, _e5712), _e5771.member_11, _e5771.member_12, _e5771.member_13, _e5771.member_14, _e5771.member_15, _e5771.member_16, _e5771.member_17, _e5771.member_18, _e5771.member_19, _e5771.member_20, _e5771.member_21, _e5771.member_22, _e5771.member_23, _e5771.member_24, _e5771.member_25, _e5771.member_26, _e5771.member_27);
phi_9401_ = type_25();
} else {
let _e2129 = (_e2107.member.x + (_e2107.member_1.x * _e2107.member_10));
let _e2132 = (_e2107.member.y + (_e2107.member_1.y * _e2107.member_10));
let _e2135 = (_e2107.member.z + (_e2107.member_1.z * _e2107.member_10));
let _e2164 = type_25(vec3<f32>(_e2129, _e2132, _e2135), _e2107.member_1, _e2107.member_2, _e2107.member_3, _e2107.member_4, _e2107.member_5, _e2107.member_6, _e2107.member_7, _e2107.member_8, _e2107.member_9, _e2107.member_10, _e2107.member_11, _e2107.member_12, _e2107.member_13, _e2107.member_14, _e2107.member_15, _e2107.member_16, _e2107.member_17, _e2107.member_18, _e2107.member_19, _e2107.member_20, _e2107.member_21, _e2107.member_22, _e2107.member_23, _e2107.member_24, _e2107.member_25, _e2107.member_26, _e2107.member_27);
let _e2166 = (_e2107.member_9 * 19i);
let _e2168 = select(_e1473, _e2166, (_e2166 < _e1473));
let _e2174 = global_2.member[bitcast<u32>(select(0i, _e2168, (_e2168 > 0i)))];
let _e2175 = (_e2166 + 1i);
let _e2177 = select(_e1473, _e2175, (_e2175 < _e1473));
let _e2183 = global_2.member[bitcast<u32>(select(0i, _e2177, (_e2177 > 0i)))];
let _e2184 = (_e2166 + 2i);
let _e2186 = select(_e1473, _e2184, (_e2184 < _e1473));
let _e2192 = global_2.member[bitcast<u32>(select(0i, _e2186, (_e2186 > 0i)))];
let _e2193 = (_e2166 + 3i);
let _e2195 = select(_e1473, _e2193, (_e2193 < _e1473));
let _e2201 = global_2.member[bitcast<u32>(select(0i, _e2195, (_e2195 > 0i)))];
let _e2202 = (_e2166 + 4i);
let _e2204 = select(_e1473, _e2202, (_e2202 < _e1473));
let _e2210 = global_2.member[bitcast<u32>(select(0i, _e2204, (_e2204 > 0i)))];
let _e2211 = (_e2166 + 5i);
let _e2213 = select(_e1473, _e2211, (_e2211 < _e1473));
let _e2219 = global_2.member[bitcast<u32>(select(0i, _e2213, (_e2213 > 0i)))];
let _e2220 = (_e2201 - _e2174);
let _e2221 = (_e2210 - _e2183);
let _e2222 = (_e2219 - _e2192);
let _e2223 = (_e2166 + 6i);
let _e2225 = select(_e1473, _e2223, (_e2223 < _e1473));
let _e2231 = global_2.member[bitcast<u32>(select(0i, _e2225, (_e2225 > 0i)))];
let _e2232 = (_e2166 + 7i);
let _e2234 = select(_e1473, _e2232, (_e2232 < _e1473));
let _e2240 = global_2.member[bitcast<u32>(select(0i, _e2234, (_e2234 > 0i)))];
let _e2241 = (_e2166 + 8i);
let _e2243 = select(_e1473, _e2241, (_e2241 < _e1473));
let _e2249 = global_2.member[bitcast<u32>(select(0i, _e2243, (_e2243 > 0i)))];
let _e2250 = (_e2231 - _e2174);
let _e2251 = (_e2240 - _e2183);
let _e2252 = (_e2249 - _e2192);
let _e2255 = ((_e2221 * _e2252) - (_e2222 * _e2251));
let _e2258 = ((_e2222 * _e2250) - (_e2220 * _e2252));
let _e2261 = ((_e2220 * _e2251) - (_e2221 * _e2250));
let _e2266 = (((_e2255 * _e2255) + (_e2258 * _e2258)) + (_e2261 * _e2261));
let _e2278 = (1f / select(1e-30f, _e2266, (_e2266 > 1e-30f)));
let _e2279 = (((_e2251 * _e2261) - (_e2252 * _e2258)) * _e2278);
let _e2280 = (((_e2252 * _e2255) - (_e2250 * _e2261)) * _e2278);
let _e2281 = (((_e2250 * _e2258) - (_e2251 * _e2255)) * _e2278);
let _e2291 = (((_e2258 * _e2222) - (_e2261 * _e2221)) * _e2278);
let _e2292 = (((_e2261 * _e2220) - (_e2255 * _e2222)) * _e2278);
let _e2293 = (((_e2255 * _e2221) - (_e2258 * _e2220)) * _e2278);
let _e2294 = (_e2166 + 9i);
let _e2296 = select(_e1473, _e2294, (_e2294 < _e1473));
let _e2302 = global_2.member[bitcast<u32>(select(0i, _e2296, (_e2296 > 0i)))];
let _e2303 = (_e2166 + 10i);
let _e2305 = select(_e1473, _e2303, (_e2303 < _e1473));
let _e2311 = global_2.member[bitcast<u32>(select(0i, _e2305, (_e2305 > 0i)))];
let _e2312 = (_e2166 + 11i);
let _e2314 = select(_e1473, _e2312, (_e2312 < _e1473));
let _e2320 = global_2.member[bitcast<u32>(select(0i, _e2314, (_e2314 > 0i)))];
let _e2321 = (_e2166 + 12i);
let _e2323 = select(_e1473, _e2321, (_e2321 < _e1473));
let _e2329 = global_2.member[bitcast<u32>(select(0i, _e2323, (_e2323 > 0i)))];
let _e2330 = (_e2166 + 13i);
let _e2332 = select(_e1473, _e2330, (_e2330 < _e1473));
let _e2338 = global_2.member[bitcast<u32>(select(0i, _e2332, (_e2332 > 0i)))];
let _e2339 = (_e2166 + 14i);
let _e2341 = select(_e1473, _e2339, (_e2339 < _e1473));
let _e2347 = global_2.member[bitcast<u32>(select(0i, _e2341, (_e2341 > 0i)))];
let _e2348 = (_e2329 - _e2302);
let _e2349 = (_e2338 - _e2311);
let _e2350 = (_e2347 - _e2320);
let _e2351 = (_e2166 + 15i);
let _e2353 = select(_e1473, _e2351, (_e2351 < _e1473));
let _e2359 = global_2.member[bitcast<u32>(select(0i, _e2353, (_e2353 > 0i)))];
let _e2360 = (_e2166 + 16i);
let _e2362 = select(_e1473, _e2360, (_e2360 < _e1473));
let _e2368 = global_2.member[bitcast<u32>(select(0i, _e2362, (_e2362 > 0i)))];
let _e2369 = (_e2166 + 17i);
let _e2371 = select(_e1473, _e2369, (_e2369 < _e1473));
let _e2377 = global_2.member[bitcast<u32>(select(0i, _e2371, (_e2371 > 0i)))];
let _e2378 = (_e2359 - _e2302);
let _e2379 = (_e2368 - _e2311);
let _e2380 = (_e2377 - _e2320);
let _e2381 = (_e2129 - _e2174);
let _e2382 = (_e2132 - _e2183);
let _e2383 = (_e2135 - _e2192);
let _e2388 = (((_e2279 * _e2381) + (_e2280 * _e2382)) + (_e2281 * _e2383));
let _e2399 = (((_e2291 * _e2381) + (_e2292 * _e2382)) + (_e2293 * _e2383));
let _e2403 = ((_e2302 + (_e2348 * _e2388)) + (_e2378 * _e2399));
let _e2404 = ((_e2311 + (_e2349 * _e2388)) + (_e2379 * _e2399));
let _e2405 = ((_e2320 + (_e2350 * _e2388)) + (_e2380 * _e2399));
let _e2410 = (((_e2403 * _e2403) + (_e2404 * _e2404)) + (_e2405 * _e2405));
let _e2413 = sqrt(select(0f, _e2410, (_e2410 > 0f)));
let _e2416 = (1f / select(1e-20f, _e2413, (_e2413 > 1e-20f)));
let _e2419 = sqrt(select(0f, _e2266, (_e2266 > 0f)));
let _e2422 = (1f / select(1e-20f, _e2419, (_e2419 > 1e-20f)));
let _e2423 = (_e2255 * _e2422);
let _e2424 = (_e2258 * _e2422);
let _e2425 = (_e2261 * _e2422);
let _e2426 = (_e2403 * _e2416);
let _e2427 = (_e2404 * _e2416);
let _e2428 = (_e2405 * _e2416);
if _e1503 {
phi_6571_ = 1f;
phi_6572_ = 1f;
} else {
let _e2430 = local_4;
let _e2431 = (_e2430 * 4i);
let _e2433 = select(_e1491, _e2431, (_e2431 < _e1491));
let _e2439 = global_3.member[bitcast<u32>(select(0i, _e2433, (_e2433 > 0i)))];
let _e2442 = local_5;
let _e2443 = (_e2442 * 4i);
let _e2445 = select(_e1491, _e2443, (_e2443 < _e1491));
let _e2451 = global_3.member[bitcast<u32>(select(0i, _e2445, (_e2445 > 0i)))];
let _e2453 = local_6;
phi_6571_ = select(_e2451, 1f, (_e2453 == 16i));
phi_6572_ = select(_e2439, 1f, _e1446);
}
let _e2457 = phi_6571_;
let _e2459 = phi_6572_;
let _e2466 = select(1f, -1f, ((((_e2107.member_1.x * _e2426) + (_e2107.member_1.y * _e2427)) + (_e2107.member_1.z * _e2428)) > 0f));
let _e2467 = (_e2426 * _e2466);
let _e2468 = (_e2427 * _e2466);
let _e2469 = (_e2428 * _e2466);
let _e2475 = -((((_e2107.member_1.x * _e2467) + (_e2107.member_1.y * _e2468)) + (_e2107.member_1.z * _e2469)));
let _e2477 = select(0f, _e2475, (_e2475 > 0f));
let _e2478 = (_e2459 / _e2457);
let _e2483 = (1f - ((_e2478 * _e2478) * (1f - (_e2477 * _e2477))));
let _e2484 = (_e2483 <= 0f);
let _e2492 = ((_e2478 * _e2477) - sqrt(select(0f, _e2483, (_e2483 > 0f))));
let _e2499 = (2f * _e2477);
let _e2503 = (_e2107.member_1.x + (_e2467 * _e2499));
let _e2504 = (_e2107.member_1.y + (_e2468 * _e2499));
let _e2505 = (_e2107.member_1.z + (_e2469 * _e2499));
let _e2506 = select(((_e2107.member_1.x * _e2478) + (_e2467 * _e2492)), _e2503, _e2484);
let _e2507 = select(((_e2107.member_1.y * _e2478) + (_e2468 * _e2492)), _e2504, _e2484);
let _e2508 = select(((_e2107.member_1.z * _e2478) + (_e2469 * _e2492)), _e2505, _e2484);
let _e2513 = (((_e2506 * _e2506) + (_e2507 * _e2507)) + (_e2508 * _e2508));
let _e2516 = sqrt(select(0f, _e2513, (_e2513 > 0f)));
let _e2519 = (1f / select(1e-20f, _e2516, (_e2516 > 1e-20f)));
let _e2527 = (((_e2107.member_1.x * _e2423) + (_e2107.member_1.y * _e2424)) + (_e2107.member_1.z * _e2425));
let _e2554 = !((((((((_e2426 * _e2107.member_1.x) + (_e2427 * _e2107.member_1.y)) + (_e2428 * _e2107.member_1.z)) * _e2527) > 0f) && (((((((_e2506 * _e2519) * _e2423) + ((_e2507 * _e2519) * _e2424)) + ((_e2508 * _e2519) * _e2425)) * select(1f, -1f, _e2484)) * _e2527) > 0f)) && ((-((((_e2503 * _e2423) + (_e2504 * _e2424)) + (_e2505 * _e2425))) * _e2527) > 0f)));
let _e2555 = select(_e2426, _e2423, _e2554);
let _e2556 = select(_e2427, _e2424, _e2554);
let _e2557 = select(_e2428, _e2425, _e2554);
let _e2558 = select(_e2279, 0f, _e2554);
let _e2559 = select(_e2280, 0f, _e2554);
let _e2560 = select(_e2281, 0f, _e2554);
let _e2561 = select(_e2291, 0f, _e2554);
let _e2562 = select(_e2292, 0f, _e2554);
let _e2563 = select(_e2293, 0f, _e2554);
let _e2575 = (_e2107.member_2.x + (_e2107.member_4.x * _e2107.member_10));
let _e2577 = (_e2107.member_2.y + (_e2107.member_4.y * _e2107.member_10));
let _e2579 = (_e2107.member_2.z + (_e2107.member_4.z * _e2107.member_10));
let _e2587 = (_e2107.member_3.x + (_e2107.member_5.x * _e2107.member_10));
let _e2589 = (_e2107.member_3.y + (_e2107.member_5.y * _e2107.member_10));
let _e2591 = (_e2107.member_3.z + (_e2107.member_5.z * _e2107.member_10));
if ((_e2527 * _e2527) > 1e-12f) {
phi_6805_ = (1f / _e2527);
} else {
phi_6805_ = 0f;
}
let _e2596 = phi_6805_;
let _e2602 = ((((_e2575 * _e2423) + (_e2577 * _e2424)) + (_e2579 * _e2425)) * _e2596);
let _e2606 = (_e2575 - (_e2107.member_1.x * _e2602));
let _e2607 = (_e2577 - (_e2107.member_1.y * _e2602));
let _e2608 = (_e2579 - (_e2107.member_1.z * _e2602));
let _e2609 = vec3<f32>(_e2606, _e2607, _e2608);
let _e2615 = ((((_e2587 * _e2423) + (_e2589 * _e2424)) + (_e2591 * _e2425)) * _e2596);
let _e2619 = (_e2587 - (_e2107.member_1.x * _e2615));
let _e2620 = (_e2589 - (_e2107.member_1.y * _e2615));
let _e2621 = (_e2591 - (_e2107.member_1.z * _e2615));
let _e2622 = vec3<f32>(_e2619, _e2620, _e2621);
let _e2650 = type_25(_e2164.member, _e2164.member_1, _e2609, _e2164.member_3, _e2164.member_4, _e2164.member_5, _e2164.member_6, _e2164.member_7, _e2164.member_8, _e2164.member_9, _e2164.member_10, _e2164.member_11, _e2164.member_12, _e2164.member_13, _e2164.member_14, _e2164.member_15, _e2164.member_16, _e2164.member_17, _e2164.member_18, _e2164.member_19, _e2164.member_20, _e2164.member_21, _e2164.member_22, _e2164.member_23, _e2164.member_24, _e2164.member_25, _e2164.member_26, _e2164.member_27);
let _e2678 = type_25(_e2650.member, _e2650.member_1, _e2650.member_2, _e2622, _e2650.member_4, _e2650.member_5, _e2650.member_6, _e2650.member_7, _e2650.member_8, _e2650.member_9, _e2650.member_10, _e2650.member_11, _e2650.member_12, _e2650.member_13, _e2650.member_14, _e2650.member_15, _e2650.member_16, _e2650.member_17, _e2650.member_18, _e2650.member_19, _e2650.member_20, _e2650.member_21, _e2650.member_22, _e2650.member_23, _e2650.member_24, _e2650.member_25, _e2650.member_26, _e2650.member_27);
let _e2706 = type_25(_e2678.member, _e2678.member_1, _e2678.member_2, _e2678.member_3, _e2107.member_4, _e2678.member_5, _e2678.member_6, _e2678.member_7, _e2678.member_8, _e2678.member_9, _e2678.member_10, _e2678.member_11, _e2678.member_12, _e2678.member_13, _e2678.member_14, _e2678.member_15, _e2678.member_16, _e2678.member_17, _e2678.member_18, _e2678.member_19, _e2678.member_20, _e2678.member_21, _e2678.member_22, _e2678.member_23, _e2678.member_24, _e2678.member_25, _e2678.member_26, _e2678.member_27);
let _e2734 = type_25(_e2706.member, _e2706.member_1, _e2706.member_2, _e2706.member_3, _e2706.member_4, _e2107.member_5, _e2706.member_6, _e2706.member_7, _e2706.member_8, _e2706.member_9, _e2706.member_10, _e2706.member_11, _e2706.member_12, _e2706.member_13, _e2706.member_14, _e2706.member_15, _e2706.member_16, _e2706.member_17, _e2706.member_18, _e2706.member_19, _e2706.member_20, _e2706.member_21, _e2706.member_22, _e2706.member_23, _e2706.member_24, _e2706.member_25, _e2706.member_26, _e2706.member_27);
if _e1503 {
let _e3468 = (_e1489 + 1i);
let _e3470 = select(_e1491, _e3468, (_e3468 < _e1491));
let _e3476 = global_3.member[bitcast<u32>(select(0i, _e3470, (_e3470 > 0i)))];
let _e3477 = (_e1489 + 2i);
let _e3479 = select(_e1491, _e3477, (_e3477 < _e1491));
let _e3485 = global_3.member[bitcast<u32>(select(0i, _e3479, (_e3479 > 0i)))];
let _e3486 = (_e1489 + 3i);
let _e3488 = select(_e1491, _e3486, (_e3486 < _e1491));
let _e3494 = global_3.member[bitcast<u32>(select(0i, _e3488, (_e3488 > 0i)))];
let _e3501 = (1f / 3f);
let _e3505 = (_e2107.member_6.x * _e3476);
let _e3508 = (_e2107.member_6.y * _e3485);
let _e3511 = (_e2107.member_6.z * _e3494);
let _e3540 = type_25(_e2734.member, _e2734.member_1, _e2734.member_2, _e2734.member_3, _e2734.member_4, _e2734.member_5, vec3<f32>(_e3505, _e3508, _e3511), _e2734.member_7, _e2734.member_8, _e2734.member_9, _e2734.member_10, _e2734.member_11, _e2734.member_12, _e2734.member_13, _e2734.member_14, _e2734.member_15, _e2734.member_16, _e2734.member_17, _e2734.member_18, _e2734.member_19, _e2734.member_20, _e2734.member_21, _e2734.member_22, _e2734.member_23, _e2734.member_24, _e2734.member_25, _e2734.member_26, _e2734.member_27);
if (bitcast<i32>(countOneBits(bitcast<u32>((_e2107.member_17 & ((1i << bitcast<u32>((_e2107.member_16 & 31i))) - 1i))))) == _e2107.member_20) {
phi_6936_ = ((((_e2107.member_6.x + _e2107.member_6.y) + _e2107.member_6.z) * _e3501) - (((_e3505 + _e3508) + _e3511) * _e3501));
} else {
phi_6936_ = 0f;
}
let _e3558 = phi_6936_;
let _e3588 = type_25(_e3540.member, _e3540.member_1, _e3540.member_2, _e3540.member_3, _e3540.member_4, _e3540.member_5, _e3540.member_6, _e3540.member_7, _e3540.member_8, _e3540.member_9, _e3540.member_10, _e3540.member_11, _e3540.member_12, _e3540.member_13, _e3540.member_14, _e3540.member_15, _e3540.member_16, _e3540.member_17, _e3540.member_18, _e3540.member_19, _e3540.member_20, _e3540.member_21, _e3540.member_22, _e3540.member_23, _e3540.member_24, (_e2107.member_25 + _e3558), _e3540.member_26, _e3540.member_27);
let _e3595 = select(1f, -1f, ((((_e2555 * _e2107.member_1.x) + (_e2556 * _e2107.member_1.y)) + (_e2557 * _e2107.member_1.z)) > 0f));
let _e3596 = (_e2555 * _e3595);
let _e3597 = (_e2556 * _e3595);
let _e3598 = (_e2557 * _e3595);
let _e3599 = (_e2348 * _e3595);
let _e3600 = (_e2349 * _e3595);
let _e3601 = (_e2350 * _e3595);
let _e3602 = (_e2378 * _e3595);
let _e3603 = (_e2379 * _e3595);
let _e3604 = (_e2380 * _e3595);
let _e3609 = (((_e2558 * _e2606) + (_e2559 * _e2607)) + (_e2560 * _e2608));
let _e3617 = (((_e2561 * _e2606) + (_e2562 * _e2607)) + (_e2563 * _e2608));
let _e3624 = (((_e3599 * _e3609) + (_e3602 * _e3617)) * _e2416);
let _e3625 = (((_e3600 * _e3609) + (_e3603 * _e3617)) * _e2416);
let _e3626 = (((_e3601 * _e3609) + (_e3604 * _e3617)) * _e2416);
let _e3631 = (((_e3596 * _e3624) + (_e3597 * _e3625)) + (_e3598 * _e3626));
let _e3635 = (_e3624 - (_e3596 * _e3631));
let _e3636 = (_e3625 - (_e3597 * _e3631));
let _e3637 = (_e3626 - (_e3598 * _e3631));
let _e3642 = (((_e2107.member_1.x * _e3596) + (_e2107.member_1.y * _e3597)) + (_e2107.member_1.z * _e3598));
let _e3643 = -(_e3642);
let _e3655 = -(((((_e2107.member_4.x * _e3596) + (_e2107.member_4.y * _e3597)) + (_e2107.member_4.z * _e3598)) + (((_e2107.member_1.x * _e3635) + (_e2107.member_1.y * _e3636)) + (_e2107.member_1.z * _e3637))));
let _e3674 = (((_e2558 * _e2619) + (_e2559 * _e2620)) + (_e2560 * _e2621));
let _e3682 = (((_e2561 * _e2619) + (_e2562 * _e2620)) + (_e2563 * _e2621));
let _e3689 = (((_e3599 * _e3674) + (_e3602 * _e3682)) * _e2416);
let _e3690 = (((_e3600 * _e3674) + (_e3603 * _e3682)) * _e2416);
let _e3691 = (((_e3601 * _e3674) + (_e3604 * _e3682)) * _e2416);
let _e3696 = (((_e3596 * _e3689) + (_e3597 * _e3690)) + (_e3598 * _e3691));
let _e3700 = (_e3689 - (_e3596 * _e3696));
let _e3701 = (_e3690 - (_e3597 * _e3696));
let _e3702 = (_e3691 - (_e3598 * _e3696));
let _e3714 = -(((((_e2107.member_5.x * _e3596) + (_e2107.member_5.y * _e3597)) + (_e2107.member_5.z * _e3598)) + (((_e2107.member_1.x * _e3700) + (_e2107.member_1.y * _e3701)) + (_e2107.member_1.z * _e3702))));
let _e3756 = type_25(_e3588.member, _e3588.member_1, _e2609, _e3588.member_3, _e3588.member_4, _e3588.member_5, _e3588.member_6, _e3588.member_7, _e3588.member_8, _e3588.member_9, _e3588.member_10, _e3588.member_11, _e3588.member_12, _e3588.member_13, _e3588.member_14, _e3588.member_15, _e3588.member_16, _e3588.member_17, _e3588.member_18, _e3588.member_19, _e3588.member_20, _e3588.member_21, _e3588.member_22, _e3588.member_23, _e3588.member_24, _e3588.member_25, _e3588.member_26, _e3588.member_27);
let _e3784 = type_25(_e3756.member, _e3756.member_1, _e3756.member_2, _e2622, _e3756.member_4, _e3756.member_5, _e3756.member_6, _e3756.member_7, _e3756.member_8, _e3756.member_9, _e3756.member_10, _e3756.member_11, _e3756.member_12, _e3756.member_13, _e3756.member_14, _e3756.member_15, _e3756.member_16, _e3756.member_17, _e3756.member_18, _e3756.member_19, _e3756.member_20, _e3756.member_21, _e3756.member_22, _e3756.member_23, _e3756.member_24, _e3756.member_25, _e3756.member_26, _e3756.member_27);
let _e3812 = type_25(_e3784.member, _e3784.member_1, _e3784.member_2, _e3784.member_3, (_e2107.member_4 + vec3<f32>((((_e3635 * _e3643) + (_e3596 * _e3655)) * 2f), (((_e3636 * _e3643) + (_e3597 * _e3655)) * 2f), (((_e3637 * _e3643) + (_e3598 * _e3655)) * 2f))), _e3784.member_5, _e3784.member_6, _e3784.member_7, _e3784.member_8, _e3784.member_9, _e3784.member_10, _e3784.member_11, _e3784.member_12, _e3784.member_13, _e3784.member_14, _e3784.member_15, _e3784.member_16, _e3784.member_17, _e3784.member_18, _e3784.member_19, _e3784.member_20, _e3784.member_21, _e3784.member_22, _e3784.member_23, _e3784.member_24, _e3784.member_25, _e3784.member_26, _e3784.member_27);
let _e3840 = type_25(_e3812.member, _e3812.member_1, _e3812.member_2, _e3812.member_3, _e3812.member_4, (_e2107.member_5 + vec3<f32>((((_e3700 * _e3643) + (_e3596 * _e3714)) * 2f), (((_e3701 * _e3643) + (_e3597 * _e3714)) * 2f), (((_e3702 * _e3643) + (_e3598 * _e3714)) * 2f))), _e3812.member_6, _e3812.member_7, _e3812.member_8, _e3812.member_9, _e3812.member_10, _e3812.member_11, _e3812.member_12, _e3812.member_13, _e3812.member_14, _e3812.member_15, _e3812.member_16, _e3812.member_17, _e3812.member_18, _e3812.member_19, _e3812.member_20, _e3812.member_21, _e3812.member_22, _e3812.member_23, _e3812.member_24, _e3812.member_25, _e3812.member_26, _e3812.member_27);
let _e3842 = select(1f, -1f, (_e3642 > 0f));
let _e3843 = (_e3596 * _e3842);
let _e3844 = (_e3597 * _e3842);
let _e3845 = (_e3598 * _e3842);
let _e3851 = -((((_e2107.member_1.x * _e3843) + (_e2107.member_1.y * _e3844)) + (_e2107.member_1.z * _e3845)));
let _e3854 = (2f * select(0f, _e3851, (_e3851 > 0f)));
let _e3887 = type_25(_e3840.member, (_e2107.member_1 + vec3<f32>((_e3843 * _e3854), (_e3844 * _e3854), (_e3845 * _e3854))), _e3840.member_2, _e3840.member_3, _e3840.member_4, _e3840.member_5, _e3840.member_6, _e3840.member_7, _e3840.member_8, _e3840.member_9, _e3840.member_10, _e3840.member_11, _e3840.member_12, _e3840.member_13, _e3840.member_14, _e3840.member_15, _e3840.member_16, _e3840.member_17, _e3840.member_18, _e3840.member_19, _e3840.member_20, _e3840.member_21, _e3840.member_22, _e3840.member_23, _e3840.member_24, _e3840.member_25, _e3840.member_26, _e3840.member_27);
phi_7940_ = type_25(_e3887.member, _e3887.member_1, _e3887.member_2, _e3887.member_3, _e3887.member_4, _e3887.member_5, _e3887.member_6, _e3887.member_7, _e3887.member_8, _e3887.member_9, _e3887.member_10, _e3887.member_11, _e3887.member_12, _e3887.member_13, _e3887.member_14, _e3887.member_15, (_e2107.member_16 + 1i), _e3887.member_17, _e3887.member_18, _e3887.member_19, _e3887.member_20, _e3887.member_21, _e3887.member_22, _e3887.member_23, _e3887.member_24, _e3887.member_25, _e3887.member_26, _e3887.member_27);
} else {
let _e2738 = global_5.member.member_12.member_2;
let _e2740 = local_7;
let _e2741 = (_e2740 * 4i);
let _e2743 = select(_e1491, _e2741, (_e2741 < _e1491));
let _e2749 = global_3.member[bitcast<u32>(select(0i, _e2743, (_e2743 > 0i)))];
let _e2750 = select(_e2749, 1f, _e1446);
let _e2752 = local_8;
let _e2753 = (_e2752 * 4i);
let _e2755 = select(_e1491, _e2753, (_e2753 < _e1491));
let _e2761 = global_3.member[bitcast<u32>(select(0i, _e2755, (_e2755 > 0i)))];
let _e2763 = local_9;
let _e2765 = select(_e2761, 1f, (_e2763 == 16i));
let _e2772 = select(1f, -1f, ((((_e2107.member_1.x * _e2555) + (_e2107.member_1.y * _e2556)) + (_e2107.member_1.z * _e2557)) > 0f));
let _e2773 = (_e2555 * _e2772);
let _e2774 = (_e2556 * _e2772);
let _e2775 = (_e2557 * _e2772);
let _e2781 = -((((_e2107.member_1.x * _e2773) + (_e2107.member_1.y * _e2774)) + (_e2107.member_1.z * _e2775)));
let _e2783 = select(0f, _e2781, (_e2781 > 0f));
let _e2784 = (_e2750 / _e2765);
let _e2785 = (_e2784 * _e2784);
let _e2786 = (_e2783 * _e2783);
let _e2789 = (1f - (_e2785 * (1f - _e2786)));
let _e2790 = (_e2789 <= 0f);
let _e2798 = ((_e2784 * _e2783) - sqrt(select(0f, _e2789, (_e2789 > 0f))));
let _e2805 = (2f * _e2783);
let _e2806 = (_e2773 * _e2805);
let _e2807 = (_e2774 * _e2805);
let _e2808 = (_e2775 * _e2805);
let _e2814 = select(((_e2107.member_1.x * _e2784) + (_e2773 * _e2798)), (_e2107.member_1.x + _e2806), _e2790);
let _e2815 = select(((_e2107.member_1.y * _e2784) + (_e2774 * _e2798)), (_e2107.member_1.y + _e2807), _e2790);
let _e2816 = select(((_e2107.member_1.z * _e2784) + (_e2775 * _e2798)), (_e2107.member_1.z + _e2808), _e2790);
let _e2821 = (((_e2814 * _e2814) + (_e2815 * _e2815)) + (_e2816 * _e2816));
let _e2824 = sqrt(select(0f, _e2821, (_e2821 > 0f)));
let _e2827 = (1f / select(1e-20f, _e2824, (_e2824 > 1e-20f)));
let _e2832 = (_e2765 / _e2750);
let _e2835 = (((_e2832 * _e2832) - 1f) + _e2786);
let _e2838 = sqrt(select(0f, _e2835, (_e2835 > 0f)));
let _e2839 = (_e2838 - _e2783);
let _e2840 = (_e2838 + _e2783);
let _e2843 = (_e2839 / select(1e-6f, _e2840, (_e2840 > 1e-6f)));
let _e2847 = ((_e2783 * _e2839) + 1f);
let _e2850 = (((_e2783 * _e2840) - 1f) / select(1e-6f, _e2847, (_e2847 > 1e-6f)));
let _e2859 = select(select((((0.5f * _e2843) * _e2843) * (1f + (_e2850 * _e2850))), 1f, (_e2835 <= 0f)), 0f, (_e2750 == _e2765));
let _e2862 = (1f - _e2859);
let _e2864 = select(_e2862, _e2859, (_e2859 < _e2862));
let _e2868 = (_e2107.member_16 & 31i);
if (!(_e2790) && (_e2107.member_16 >= _e2107.member_19)) {
let _e2881 = select(_e2107.member_6.y, _e2107.member_6.x, (_e2107.member_6.x > _e2107.member_6.y));
let _e2886 = ((select(_e2107.member_6.z, _e2881, (_e2881 > _e2107.member_6.z)) * _e2864) >= _e2738);
let _e2888 = (1i << bitcast<u32>(_e2868));
if (bitcast<i32>(countOneBits(bitcast<u32>((_e2107.member_17 & (_e2888 - 1i))))) == _e2107.member_20) {
if _e2886 {
phi_7609_ = type_25(_e2734.member, _e2734.member_1, _e2734.member_2, _e2734.member_3, _e2734.member_4, _e2734.member_5, _e2734.member_6, _e2734.member_7, _e2734.member_8, _e2734.member_9, _e2734.member_10, _e2734.member_11, _e2734.member_12, _e2734.member_13, _e2734.member_14, _e2734.member_15, _e2734.member_16, _e2734.member_17, _e2734.member_18, _e2734.member_19, _e2734.member_20, 1i, _e2734.member_22, _e2734.member_23, _e2734.member_24, _e2734.member_25, _e2734.member_26, _e2734.member_27);
} else {
phi_7609_ = type_25(_e2734.member, _e2734.member_1, _e2734.member_2, _e2734.member_3, _e2734.member_4, _e2734.member_5, _e2734.member_6, _e2734.member_7, _e2734.member_8, _e2734.member_9, _e2734.member_10, _e2734.member_11, _e2734.member_12, _e2734.member_13, _e2734.member_14, _e2734.member_15, _e2734.member_16, _e2734.member_17, _e2734.member_18, _e2734.member_19, _e2734.member_20, _e2734.member_21, _e2734.member_22, _e2734.member_23, _e2734.member_24, _e2734.member_25, _e2734.member_26, (_e2107.member_27 + ((((_e2107.member_6.x + _e2107.member_6.y) + _e2107.member_6.z) * (1f / 3f)) * _e2864)));
}
let _e2991 = phi_7609_;
phi_7619_ = _e2991;
} else {
phi_7619_ = type_25(_e2734.member, _e2734.member_1, _e2734.member_2, _e2734.member_3, _e2734.member_4, _e2734.member_5, _e2734.member_6, _e2734.member_7, _e2734.member_8, _e2734.member_9, _e2734.member_10, _e2734.member_11, _e2734.member_12, _e2734.member_13, _e2734.member_14, _e2734.member_15, _e2734.member_16, _e2734.member_17, (_e2107.member_18 | select(0i, _e2888, _e2886)), _e2734.member_19, _e2734.member_20, _e2734.member_21, _e2734.member_22, _e2734.member_23, _e2734.member_24, _e2734.member_25, _e2734.member_26, _e2734.member_27);
}
let _e2993 = phi_7619_;
phi_7620_ = _e2993;
} else {
phi_7620_ = _e2734;
}
let _e2995 = phi_7620_;
let _e2996 = (((_e2107.member_16 < _e2107.member_19) && (((_e2107.member_17 >> bitcast<u32>(_e2868)) & 1i) == 1i)) != (_e2859 > 0.5f));
let _e2997 = (_e2790 || _e2996);
if _e2790 {
phi_7640_ = _e2995;
} else {
let _e2998 = select(_e2862, _e2859, _e2996);
phi_7640_ = type_25(_e2995.member, _e2995.member_1, _e2995.member_2, _e2995.member_3, _e2995.member_4, _e2995.member_5, vec3<f32>((_e2995.member_6.x * _e2998), (_e2995.member_6.y * _e2998), (_e2995.member_6.z * _e2998)), _e2995.member_7, _e2995.member_8, _e2995.member_9, _e2995.member_10, _e2995.member_11, _e2995.member_12, _e2995.member_13, _e2995.member_14, _e2995.member_15, _e2995.member_16, _e2995.member_17, _e2995.member_18, _e2995.member_19, _e2995.member_20, _e2995.member_21, _e2995.member_22, _e2995.member_23, _e2995.member_24, _e2995.member_25, _e2995.member_26, _e2995.member_27);
}
let _e3038 = phi_7640_;
let _e3049 = select(1f, -1f, ((((_e2555 * _e3038.member_1.x) + (_e2556 * _e3038.member_1.y)) + (_e2557 * _e3038.member_1.z)) > 0f));
let _e3050 = (_e2555 * _e3049);
let _e3051 = (_e2556 * _e3049);
let _e3052 = (_e2557 * _e3049);
let _e3053 = (_e2348 * _e3049);
let _e3054 = (_e2349 * _e3049);
let _e3055 = (_e2350 * _e3049);
let _e3056 = (_e2378 * _e3049);
let _e3057 = (_e2379 * _e3049);
let _e3058 = (_e2380 * _e3049);
let _e3070 = (((_e2558 * _e3038.member_2.x) + (_e2559 * _e3038.member_2.y)) + (_e2560 * _e3038.member_2.z));
let _e3078 = (((_e2561 * _e3038.member_2.x) + (_e2562 * _e3038.member_2.y)) + (_e2563 * _e3038.member_2.z));
let _e3085 = (((_e3053 * _e3070) + (_e3056 * _e3078)) * _e2416);
let _e3086 = (((_e3054 * _e3070) + (_e3057 * _e3078)) * _e2416);
let _e3087 = (((_e3055 * _e3070) + (_e3058 * _e3078)) * _e2416);
let _e3092 = (((_e3050 * _e3085) + (_e3051 * _e3086)) + (_e3052 * _e3087));
let _e3096 = (_e3085 - (_e3050 * _e3092));
let _e3097 = (_e3086 - (_e3051 * _e3092));
let _e3098 = (_e3087 - (_e3052 * _e3092));
let _e3104 = -((((_e3038.member_1.x * _e3050) + (_e3038.member_1.y * _e3051)) + (_e3038.member_1.z * _e3052)));
let _e3119 = -(((((_e3038.member_4.x * _e3050) + (_e3038.member_4.y * _e3051)) + (_e3038.member_4.z * _e3052)) + (((_e3038.member_1.x * _e3096) + (_e3038.member_1.y * _e3097)) + (_e3038.member_1.z * _e3098))));
if _e2997 {
phi_7795_ = (_e3038.member_4 + vec3<f32>((((_e3096 * _e3104) + (_e3050 * _e3119)) * 2f), (((_e3097 * _e3104) + (_e3051 * _e3119)) * 2f), (((_e3098 * _e3104) + (_e3052 * _e3119)) * 2f)));
} else {
let _e3123 = (1f - (_e2785 * (1f - (_e3104 * _e3104))));
let _e3125 = select(1e-12f, _e3123, (_e3123 > 1e-12f));
let _e3128 = sqrt(select(0f, _e3125, (_e3125 > 0f)));
let _e3130 = ((_e2784 * _e3104) - _e3128);
let _e3134 = ((_e2784 - ((_e2785 * _e3104) / _e3128)) * _e3119);
phi_7795_ = vec3<f32>((((_e3038.member_4.x * _e2784) + (_e3096 * _e3130)) + (_e3050 * _e3134)), (((_e3038.member_4.y * _e2784) + (_e3097 * _e3130)) + (_e3051 * _e3134)), (((_e3038.member_4.z * _e2784) + (_e3098 * _e3130)) + (_e3052 * _e3134)));
}
let _e3166 = phi_7795_;
let _e3174 = (((_e2558 * _e3038.member_3.x) + (_e2559 * _e3038.member_3.y)) + (_e2560 * _e3038.member_3.z));
let _e3182 = (((_e2561 * _e3038.member_3.x) + (_e2562 * _e3038.member_3.y)) + (_e2563 * _e3038.member_3.z));
let _e3189 = (((_e3053 * _e3174) + (_e3056 * _e3182)) * _e2416);
let _e3190 = (((_e3054 * _e3174) + (_e3057 * _e3182)) * _e2416);
let _e3191 = (((_e3055 * _e3174) + (_e3058 * _e3182)) * _e2416);
let _e3196 = (((_e3050 * _e3189) + (_e3051 * _e3190)) + (_e3052 * _e3191));
let _e3200 = (_e3189 - (_e3050 * _e3196));
let _e3201 = (_e3190 - (_e3051 * _e3196));
let _e3202 = (_e3191 - (_e3052 * _e3196));
let _e3217 = -(((((_e3038.member_5.x * _e3050) + (_e3038.member_5.y * _e3051)) + (_e3038.member_5.z * _e3052)) + (((_e3038.member_1.x * _e3200) + (_e3038.member_1.y * _e3201)) + (_e3038.member_1.z * _e3202))));
if _e2997 {
phi_7921_ = (_e3038.member_5 + vec3<f32>((((_e3200 * _e3104) + (_e3050 * _e3217)) * 2f), (((_e3201 * _e3104) + (_e3051 * _e3217)) * 2f), (((_e3202 * _e3104) + (_e3052 * _e3217)) * 2f)));
} else {
let _e3221 = (1f - (_e2785 * (1f - (_e3104 * _e3104))));
let _e3223 = select(1e-12f, _e3221, (_e3221 > 1e-12f));
let _e3226 = sqrt(select(0f, _e3223, (_e3223 > 0f)));
let _e3228 = ((_e2784 * _e3104) - _e3226);
let _e3232 = ((_e2784 - ((_e2785 * _e3104) / _e3226)) * _e3217);
phi_7921_ = vec3<f32>((((_e3038.member_5.x * _e2784) + (_e3200 * _e3228)) + (_e3050 * _e3232)), (((_e3038.member_5.y * _e2784) + (_e3201 * _e3228)) + (_e3051 * _e3232)), (((_e3038.member_5.z * _e2784) + (_e3202 * _e3228)) + (_e3052 * _e3232)));
}
let _e3264 = phi_7921_;
let _e3292 = type_25(_e3038.member, _e3038.member_1, _e3038.member_2, _e3038.member_3, _e3038.member_4, _e3038.member_5, _e3038.member_6, _e3038.member_7, _e3038.member_8, _e3038.member_9, _e3038.member_10, _e3038.member_11, _e3038.member_12, _e3038.member_13, _e3038.member_14, _e3038.member_15, _e3038.member_16, _e3038.member_17, _e3038.member_18, _e3038.member_19, _e3038.member_20, _e3038.member_21, _e3038.member_22, _e3038.member_23, _e3038.member_24, _e3038.member_25, _e3038.member_26, _e3038.member_27);
let _e3320 = type_25(_e3292.member, _e3292.member_1, _e3292.member_2, _e3038.member_3, _e3292.member_4, _e3292.member_5, _e3292.member_6, _e3292.member_7, _e3292.member_8, _e3292.member_9, _e3292.member_10, _e3292.member_11, _e3292.member_12, _e3292.member_13, _e3292.member_14, _e3292.member_15, _e3292.member_16, _e3292.member_17, _e3292.member_18, _e3292.member_19, _e3292.member_20, _e3292.member_21, _e3292.member_22, _e3292.member_23, _e3292.member_24, _e3292.member_25, _e3292.member_26, _e3292.member_27);
let _e3348 = type_25(_e3320.member, _e3320.member_1, _e3320.member_2, _e3320.member_3, _e3166, _e3320.member_5, _e3320.member_6, _e3320.member_7, _e3320.member_8, _e3320.member_9, _e3320.member_10, _e3320.member_11, _e3320.member_12, _e3320.member_13, _e3320.member_14, _e3320.member_15, _e3320.member_16, _e3320.member_17, _e3320.member_18, _e3320.member_19, _e3320.member_20, _e3320.member_21, _e3320.member_22, _e3320.member_23, _e3320.member_24, _e3320.member_25, _e3320.member_26, _e3320.member_27);
let _e3376 = type_25(_e3348.member, _e3348.member_1, _e3348.member_2, _e3348.member_3, _e3348.member_4, _e3264, _e3348.member_6, _e3348.member_7, _e3348.member_8, _e3348.member_9, _e3348.member_10, _e3348.member_11, _e3348.member_12, _e3348.member_13, _e3348.member_14, _e3348.member_15, _e3348.member_16, _e3348.member_17, _e3348.member_18, _e3348.member_19, _e3348.member_20, _e3348.member_21, _e3348.member_22, _e3348.member_23, _e3348.member_24, _e3348.member_25, _e3348.member_26, _e3348.member_27);
let _e3406 = type_25(_e3376.member, select(vec3<f32>((_e2814 * _e2827), (_e2815 * _e2827), (_e2816 * _e2827)), (_e2107.member_1 + vec3<f32>(_e2806, _e2807, _e2808)), vec3(_e2997)), _e3376.member_2, _e3376.member_3, _e3376.member_4, _e3376.member_5, _e3376.member_6, _e3376.member_7, _e3376.member_8, _e3376.member_9, _e3376.member_10, _e3376.member_11, _e3376.member_12, _e3376.member_13, _e3376.member_14, _e3376.member_15, _e3376.member_16, _e3376.member_17, _e3376.member_18, _e3376.member_19, _e3376.member_20, _e3376.member_21, _e3376.member_22, _e3376.member_23, _e3376.member_24, _e3376.member_25, _e3376.member_26, _e3376.member_27);
let _e3436 = type_25(_e3406.member, _e3406.member_1, _e3406.member_2, _e3406.member_3, _e3406.member_4, _e3406.member_5, _e3406.member_6, _e3406.member_7, _e3406.member_8, _e3406.member_9, _e3406.member_10, _e3406.member_11, _e3406.member_12, _e3406.member_13, _e3406.member_14, _e3406.member_15, (_e3038.member_16 + 1i), _e3406.member_17, _e3406.member_18, _e3406.member_19, _e3406.member_20, _e3406.member_21, _e3406.member_22, _e3406.member_23, _e3406.member_24, _e3406.member_25, _e3406.member_26, _e3406.member_27);
if !(_e2997) {
phi_7939_ = type_25(_e3436.member, _e3436.member_1, _e3436.member_2, _e3436.member_3, _e3436.member_4, _e3436.member_5, _e3436.member_6, _e1512, _e3436.member_8, _e3436.member_9, _e3436.member_10, _e3436.member_11, _e3436.member_12, _e3436.member_13, _e3436.member_14, _e3436.member_15, _e3436.member_16, _e3436.member_17, _e3436.member_18, _e3436.member_19, _e3436.member_20, _e3436.member_21, _e3436.member_22, _e3436.member_23, _e3436.member_24, _e3436.member_25, _e3436.member_26, _e3436.member_27);
} else {
phi_7939_ = _e3436;
}
let _e3467 = phi_7939_;
phi_7940_ = _e3467;
}
let _e3918 = phi_7940_;
let _e3946 = type_25(_e3918.member, _e3918.member_1, _e3918.member_2, _e3918.member_3, _e3918.member_4, _e3918.member_5, _e3918.member_6, _e3918.member_7, _e3918.member_8, _e3918.member_9, _e3918.member_10, _e3918.member_11, _e3918.member_12, 0f, _e3918.member_14, _e3918.member_15, _e3918.member_16, _e3918.member_17, _e3918.member_18, _e3918.member_19, _e3918.member_20, _e3918.member_21, _e3918.member_22, _e3918.member_23, _e3918.member_24, _e3918.member_25, _e3918.member_26, _e3918.member_27);
let _e3974 = type_25(_e3946.member, _e3946.member_1, _e3946.member_2, _e3946.member_3, _e3946.member_4, _e3946.member_5, _e3946.member_6, _e3946.member_7, _e3946.member_8, _e3946.member_9, _e3946.member_10, 0i, _e3946.member_12, _e3946.member_13, _e3946.member_14, _e3946.member_15, _e3946.member_16, _e3946.member_17, _e3946.member_18, _e3946.member_19, _e3946.member_20, _e3946.member_21, _e3946.member_22, _e3946.member_23, _e3946.member_24, _e3946.member_25, _e3946.member_26, _e3946.member_27);
let _e4002 = type_25(_e3974.member, _e3974.member_1, _e3974.member_2, _e3974.member_3, _e3974.member_4, _e3974.member_5, _e3974.member_6, _e3974.member_7, _e3974.member_8, _e3974.member_9, _e3974.member_10, _e3974.member_11, 0i, _e3974.member_13, _e3974.member_14, _e3974.member_15, _e3974.member_16, _e3974.member_17, _e3974.member_18, _e3974.member_19, _e3974.member_20, _e3974.member_21, _e3974.member_22, _e3974.member_23, _e3974.member_24, _e3974.member_25, _e3974.member_26, _e3974.member_27);
let _e4009 = global_5.member.member_14.member.member;
let _e4023 = ((((_e4009.member.member * _e3918.member.x) + (_e4009.member.member_1 * _e3918.member.y)) + (_e4009.member.member_2 * _e3918.member.z)) + _e4009.member_1);
let _e4032 = -((((_e4009.member.member * _e3918.member_1.x) + (_e4009.member.member_1 * _e3918.member_1.y)) + (_e4009.member.member_2 * _e3918.member_1.z)));
let _e4034 = (_e4032 > 1e-9f);
let _e4038 = ((_e4023 / select(1e-9f, _e4032, _e4034)) - 0.015625f);
let _e4041 = select(1e30f, select(0f, _e4038, (_e4038 > 0f)), ((_e4023 > 0f) && _e4034));
let _e4046 = global_5.member.member_14.member_1.member;
let _e4057 = ((((_e4046.member.member * _e3918.member.x) + (_e4046.member.member_1 * _e3918.member.y)) + (_e4046.member.member_2 * _e3918.member.z)) + _e4046.member_1);
let _e4063 = -((((_e4046.member.member * _e3918.member_1.x) + (_e4046.member.member_1 * _e3918.member_1.y)) + (_e4046.member.member_2 * _e3918.member_1.z)));
let _e4065 = (_e4063 > 1e-9f);
let _e4069 = ((_e4057 / select(1e-9f, _e4063, _e4065)) - 0.015625f);
let _e4072 = select(1e30f, select(0f, _e4069, (_e4069 > 0f)), ((_e4057 > 0f) && _e4065));
let _e4076 = (_e4072 < _e4041);
let _e4107 = type_25(_e4002.member, _e4002.member_1, _e4002.member_2, _e4002.member_3, _e4002.member_4, _e4002.member_5, _e4002.member_6, _e4002.member_7, 0i, _e4002.member_9, _e4002.member_10, _e4002.member_11, _e4002.member_12, _e4002.member_13, _e4002.member_14, _e4002.member_15, _e4002.member_16, _e4002.member_17, _e4002.member_18, _e4002.member_19, _e4002.member_20, _e4002.member_21, _e4002.member_22, _e4002.member_23, _e4002.member_24, _e4002.member_25, _e4002.member_26, _e4002.member_27);
let _e4135 = type_25(_e4107.member, _e4107.member_1, _e4107.member_2, _e4107.member_3, _e4107.member_4, _e4107.member_5, _e4107.member_6, _e4107.member_7, _e4107.member_8, select(select(-2i, -3i, _e4076), -1i, ((_e4041 >= 1e30f) && (_e4072 >= 1e30f))), _e4107.member_10, _e4107.member_11, _e4107.member_12, _e4107.member_13, _e4107.member_14, _e4107.member_15, _e4107.member_16, _e4107.member_17, _e4107.member_18, _e4107.member_19, _e4107.member_20, _e4107.member_21, _e4107.member_22, _e4107.member_23, _e4107.member_24, _e4107.member_25, _e4107.member_26, _e4107.member_27);
let _e4163 = type_25(_e4135.member, _e4135.member_1, _e4135.member_2, _e4135.member_3, _e4135.member_4, _e4135.member_5, _e4135.member_6, _e4135.member_7, _e4135.member_8, _e4135.member_9, select(_e4041, _e4072, _e4076), _e4135.member_11, _e4135.member_12, _e4135.member_13, _e4135.member_14, _e4135.member_15, _e4135.member_16, _e4135.member_17, _e4135.member_18, _e4135.member_19, _e4135.member_20, _e4135.member_21, _e4135.member_22, _e4135.member_23, _e4135.member_24, _e4135.member_25, _e4135.member_26, _e4135.member_27);
let _e4168 = global_5.member.member_12.member_3;
if (_e3918.member_16 > bitcast<i32>(_e4168)) {
if (bitcast<i32>(countOneBits(bitcast<u32>((_e3918.member_17 & ((1i << bitcast<u32>((_e3918.member_16 & 31i))) - 1i))))) == _e3918.member_20) {
phi_8095_ = (((_e3918.member_6.x + _e3918.member_6.y) + _e3918.member_6.z) * (1f / 3f));
} else {
phi_8095_ = 0f;
}
let _e4191 = phi_8095_;
let _e4221 = type_25(_e4163.member, _e4163.member_1, _e4163.member_2, _e4163.member_3, _e4163.member_4, _e4163.member_5, _e4163.member_6, _e4163.member_7, _e4163.member_8, _e4163.member_9, _e4163.member_10, _e4163.member_11, _e4163.member_12, _e4163.member_13, _e4163.member_14, _e4163.member_15, _e4163.member_16, _e4163.member_17, _e4163.member_18, _e4163.member_19, _e4163.member_20, _e4163.member_21, _e4163.member_22, _e4163.member_23, _e4163.member_24, _e4163.member_25, _e4163.member_26, (_e3918.member_27 + _e4191));
let _e4223 = (_e3918.member_18 == 0i);
if (_e4223 && (_e3918.member_21 == 0i)) {
phi_9398_ = type_25(_e4221.member, _e4221.member_1, _e4221.member_2, _e4221.member_3, _e4221.member_4, _e4221.member_5, _e4221.member_6, _e4221.member_7, _e4221.member_8, _e4221.member_9, _e4221.member_10, _e4221.member_11, _e4221.member_12, _e4221.member_13, _e4221.member_14, 3f, _e4221.member_16, _e4221.member_17, _e4221.member_18, _e4221.member_19, _e4221.member_20, _e4221.member_21, _e4221.member_22, _e4221.member_23, _e4221.member_24, _e4221.member_25, _e4221.member_26, _e4221.member_27);
} else {
if _e4223 {
let _e4353 = type_25(_e4221.member, _e4221.member_1, _e4221.member_2, _e4221.member_3, _e4221.member_4, _e4221.member_5, _e4221.member_6, _e4221.member_7, _e4221.member_8, _e4221.member_9, _e4221.member_10, _e4221.member_11, _e4221.member_12, _e4221.member_13, _e4221.member_14, _e4221.member_15, _e4221.member_16, _e4221.member_17, _e4221.member_18, _e4221.member_19, (_e3918.member_20 + 1i), _e4221.member_21, _e4221.member_22, _e4221.member_23, _e4221.member_24, _e4221.member_25, _e4221.member_26, _e4221.member_27);
let _e4381 = type_25(_e4353.member, _e4353.member_1, _e4353.member_2, _e4353.member_3, _e4353.member_4, _e4353.member_5, _e4353.member_6, _e4353.member_7, _e4353.member_8, _e4353.member_9, _e4353.member_10, _e4353.member_11, _e4353.member_12, _e4353.member_13, _e4353.member_14, _e4353.member_15, _e4353.member_16, _e4353.member_17, _e4353.member_18, _e4353.member_19, _e4353.member_20, 0i, _e4353.member_22, _e4353.member_23, _e4353.member_24, _e4353.member_25, _e4353.member_26, _e4353.member_27);
let _e4409 = type_25(_e4381.member, _e4381.member_1, _e4381.member_2, _e4381.member_3, _e4381.member_4, _e4381.member_5, _e4381.member_6, _e4381.member_7, _e4381.member_8, _e4381.member_9, _e4381.member_10, _e4381.member_11, _e4381.member_12, _e4381.member_13, _e4381.member_14, _e4381.member_15, _e4381.member_16, 0i, _e4381.member_18, _e4381.member_19, _e4381.member_20, _e4381.member_21, _e4381.member_22, _e4381.member_23, _e4381.member_24, _e4381.member_25, _e4381.member_26, _e4381.member_27);
phi_8139_ = type_25(_e4409.member, _e4409.member_1, _e4409.member_2, _e4409.member_3, _e4409.member_4, _e4409.member_5, _e4409.member_6, _e4409.member_7, _e4409.member_8, _e4409.member_9, _e4409.member_10, _e4409.member_11, _e4409.member_12, _e4409.member_13, _e4409.member_14, _e4409.member_15, _e4409.member_16, _e4409.member_17, _e4409.member_18, 0i, _e4409.member_20, _e4409.member_21, _e4409.member_22, _e4409.member_23, _e4409.member_24, _e4409.member_25, _e4409.member_26, _e4409.member_27);
} else {
let _e4231 = bitcast<i32>((bitcast<u32>(f32(_e3918.member_18)) >> bitcast<u32>(23i)));
let _e4235 = (1i << bitcast<u32>(((_e4231 - 127i) & 31i)));
let _e4236 = (_e4235 - 1i);
let _e4266 = type_25(_e4221.member, _e4221.member_1, _e4221.member_2, _e4221.member_3, _e4221.member_4, _e4221.member_5, _e4221.member_6, _e4221.member_7, _e4221.member_8, _e4221.member_9, _e4221.member_10, _e4221.member_11, _e4221.member_12, _e4221.member_13, _e4221.member_14, _e4221.member_15, _e4221.member_16, ((_e3918.member_17 & _e4236) | _e4235), _e4221.member_18, _e4221.member_19, _e4221.member_20, _e4221.member_21, _e4221.member_22, _e4221.member_23, _e4221.member_24, _e4221.member_25, _e4221.member_26, _e4221.member_27);
let _e4295 = type_25(_e4266.member, _e4266.member_1, _e4266.member_2, _e4266.member_3, _e4266.member_4, _e4266.member_5, _e4266.member_6, _e4266.member_7, _e4266.member_8, _e4266.member_9, _e4266.member_10, _e4266.member_11, _e4266.member_12, _e4266.member_13, _e4266.member_14, _e4266.member_15, _e4266.member_16, _e4266.member_17, (_e3918.member_18 & _e4236), _e4266.member_19, _e4266.member_20, _e4266.member_21, _e4266.member_22, _e4266.member_23, _e4266.member_24, _e4266.member_25, _e4266.member_26, _e4266.member_27);
phi_8139_ = type_25(_e4295.member, _e4295.member_1, _e4295.member_2, _e4295.member_3, _e4295.member_4, _e4295.member_5, _e4295.member_6, _e4295.member_7, _e4295.member_8, _e4295.member_9, _e4295.member_10, _e4295.member_11, _e4295.member_12, _e4295.member_13, _e4295.member_14, _e4295.member_15, _e4295.member_16, _e4295.member_17, _e4295.member_18, (_e4231 + -126i), _e4295.member_20, _e4295.member_21, _e4295.member_22, _e4295.member_23, _e4295.member_24, _e4295.member_25, _e4295.member_26, _e4295.member_27);
}
let _e4439 = phi_8139_;
let _e4445 = global_5.member.member_1.member;
let _e4447 = f32(bitcast<i32>(_e4445));
let _e4451 = global_5.member.member_1.member_1;
let _e4453 = f32(bitcast<i32>(_e4451));
let _e4463 = global_5.member.member_2.member;
let _e4464 = (((((f32(bitcast<i32>(_e121.x)) + 0.5f) / _e4447) * 2f) - 1f) * _e4463);
let _e4472 = global_5.member.member_2.member_1;
let _e4473 = ((1f - (((f32(bitcast<i32>(_e121.y)) + 0.5f) / _e4453) * 2f)) * _e4472);
let _e4476 = global_5.member.member_3;
let _e4485 = global_5.member.member_4;
let _e4492 = ((_e4476.member * _e4464) + (_e4485.member * _e4473));
let _e4493 = ((_e4476.member_1 * _e4464) + (_e4485.member_1 * _e4473));
let _e4494 = ((_e4476.member_2 * _e4464) + (_e4485.member_2 * _e4473));
let _e4498 = global_5.member.member_2.member_3;
let _e4499 = (_e4498 != 0u);
let _e4502 = global_5.member.member_5;
let _e4509 = select((_e4502.member + _e4492), _e4502.member, _e4499);
let _e4510 = select((_e4502.member_1 + _e4493), _e4502.member_1, _e4499);
let _e4511 = select((_e4502.member_2 + _e4494), _e4502.member_2, _e4499);
let _e4514 = global_5.member.member_6;
let _e4521 = select(_e4514.member, (_e4514.member + _e4492), _e4499);
let _e4522 = select(_e4514.member_1, (_e4514.member_1 + _e4493), _e4499);
let _e4523 = select(_e4514.member_2, (_e4514.member_2 + _e4494), _e4499);
let _e4529 = (((_e4509 * _e4509) + (_e4510 * _e4510)) + (_e4511 * _e4511));
let _e4533 = (1f / sqrt(select(0f, _e4529, (_e4529 > 0f))));
let _e4534 = (_e4509 * _e4533);
let _e4535 = (_e4510 * _e4533);
let _e4536 = (_e4511 * _e4533);
let _e4539 = ((2f * _e4463) / _e4447);
let _e4540 = (_e4476.member * _e4539);
let _e4541 = (_e4476.member_1 * _e4539);
let _e4542 = (_e4476.member_2 * _e4539);
let _e4544 = ((-2f * _e4472) / _e4453);
let _e4545 = (_e4485.member * _e4544);
let _e4546 = (_e4485.member_1 * _e4544);
let _e4547 = (_e4485.member_2 * _e4544);
let _e4560 = (((_e4540 * _e4534) + (_e4541 * _e4535)) + (_e4542 * _e4536));
let _e4570 = select(((_e4540 - (_e4534 * _e4560)) * _e4533), 0f, _e4499);
let _e4571 = select(((_e4541 - (_e4535 * _e4560)) * _e4533), 0f, _e4499);
let _e4572 = select(((_e4542 - (_e4536 * _e4560)) * _e4533), 0f, _e4499);
let _e4578 = (((_e4545 * _e4534) + (_e4546 * _e4535)) + (_e4547 * _e4536));
let _e4588 = select(((_e4545 - (_e4534 * _e4578)) * _e4533), 0f, _e4499);
let _e4589 = select(((_e4546 - (_e4535 * _e4578)) * _e4533), 0f, _e4499);
let _e4590 = select(((_e4547 - (_e4536 * _e4578)) * _e4533), 0f, _e4499);
let _e4599 = (1f / select(_e4534, select(1e-12f, -1e-12f, (_e4534 < 0f)), (bitcast<f32>((bitcast<u32>(_e4534) & 2147483647u)) < 1e-12f)));
let _e4607 = (1f / select(_e4535, select(1e-12f, -1e-12f, (_e4535 < 0f)), (bitcast<f32>((bitcast<u32>(_e4535) & 2147483647u)) < 1e-12f)));
let _e4615 = (1f / select(_e4536, select(1e-12f, -1e-12f, (_e4536 < 0f)), (bitcast<f32>((bitcast<u32>(_e4536) & 2147483647u)) < 1e-12f)));
let _e4618 = global_5.member.member_8;
let _e4624 = global_5.member.member_9;
let _e4629 = ((_e4618.member - _e4521) * _e4599);
let _e4631 = ((_e4624.member - _e4521) * _e4599);
let _e4633 = ((_e4618.member_1 - _e4522) * _e4607);
let _e4635 = ((_e4624.member_1 - _e4522) * _e4607);
let _e4637 = ((_e4618.member_2 - _e4523) * _e4615);
let _e4639 = ((_e4624.member_2 - _e4523) * _e4615);
let _e4641 = select(_e4631, _e4629, (_e4629 < _e4631));
let _e4643 = select(_e4635, _e4633, (_e4633 < _e4635));
let _e4645 = select(_e4643, _e4641, (_e4641 > _e4643));
let _e4647 = select(_e4639, _e4637, (_e4637 < _e4639));
let _e4649 = select(_e4647, _e4645, (_e4645 > _e4647));
let _e4651 = select(_e4631, _e4629, (_e4629 > _e4631));
let _e4653 = select(_e4635, _e4633, (_e4633 > _e4635));
let _e4655 = select(_e4653, _e4651, (_e4651 < _e4653));
let _e4657 = select(_e4639, _e4637, (_e4637 > _e4639));
let _e4661 = select(0f, _e4649, (_e4649 > 0f));
let _e4667 = ((((_e4009.member.member * _e4521) + (_e4009.member.member_1 * _e4522)) + (_e4009.member.member_2 * _e4523)) + _e4009.member_1);
let _e4673 = -((((_e4009.member.member * _e4534) + (_e4009.member.member_1 * _e4535)) + (_e4009.member.member_2 * _e4536)));
let _e4675 = (_e4673 > 1e-9f);
let _e4677 = select(1e-9f, _e4673, _e4675);
let _e4679 = ((_e4667 / _e4677) - 0.015625f);
let _e4682 = select(1e30f, select(0f, _e4679, (_e4679 > 0f)), ((_e4667 > 0f) && _e4675));
let _e4688 = ((((_e4046.member.member * _e4521) + (_e4046.member.member_1 * _e4522)) + (_e4046.member.member_2 * _e4523)) + _e4046.member_1);
let _e4694 = -((((_e4046.member.member * _e4534) + (_e4046.member.member_1 * _e4535)) + (_e4046.member.member_2 * _e4536)));
let _e4696 = (_e4694 > 1e-9f);
let _e4698 = select(1e-9f, _e4694, _e4696);
let _e4700 = ((_e4688 / _e4698) - 0.015625f);
let _e4703 = select(1e30f, select(0f, _e4700, (_e4700 > 0f)), ((_e4688 > 0f) && _e4696));
let _e4709 = ((select(_e4657, _e4655, (_e4655 < _e4657)) <= _e4661) || (true && (select(_e4682, _e4703, (_e4703 < _e4682)) <= _e4661)));
let _e4710 = select(_e4661, 0f, _e4709);
let _e4711 = (_e4534 * _e4710);
let _e4712 = (_e4535 * _e4710);
let _e4713 = (_e4536 * _e4710);
let _e4714 = (_e4521 + _e4711);
let _e4715 = (_e4522 + _e4712);
let _e4716 = (_e4523 + _e4713);
let _e4746 = type_25((vec3<f32>(_e4521, _e4522, _e4523) + vec3<f32>(_e4711, _e4712, _e4713)), _e4439.member_1, _e4439.member_2, _e4439.member_3, _e4439.member_4, _e4439.member_5, _e4439.member_6, _e4439.member_7, _e4439.member_8, _e4439.member_9, _e4439.member_10, _e4439.member_11, _e4439.member_12, _e4439.member_13, _e4439.member_14, _e4439.member_15, _e4439.member_16, _e4439.member_17, _e4439.member_18, _e4439.member_19, _e4439.member_20, _e4439.member_21, _e4439.member_22, _e4439.member_23, _e4439.member_24, _e4439.member_25, _e4439.member_26, _e4439.member_27);
let _e4774 = type_25(_e4746.member, vec3<f32>(_e4534, _e4535, _e4536), _e4746.member_2, _e4746.member_3, _e4746.member_4, _e4746.member_5, _e4746.member_6, _e4746.member_7, _e4746.member_8, _e4746.member_9, _e4746.member_10, _e4746.member_11, _e4746.member_12, _e4746.member_13, _e4746.member_14, _e4746.member_15, _e4746.member_16, _e4746.member_17, _e4746.member_18, _e4746.member_19, _e4746.member_20, _e4746.member_21, _e4746.member_22, _e4746.member_23, _e4746.member_24, _e4746.member_25, _e4746.member_26, _e4746.member_27);
let _e4812 = type_25(_e4774.member, _e4774.member_1, (vec3<f32>(select(0f, _e4540, _e4499), select(0f, _e4541, _e4499), select(0f, _e4542, _e4499)) + vec3<f32>((_e4570 * _e4710), (_e4571 * _e4710), (_e4572 * _e4710))), _e4774.member_3, _e4774.member_4, _e4774.member_5, _e4774.member_6, _e4774.member_7, _e4774.member_8, _e4774.member_9, _e4774.member_10, _e4774.member_11, _e4774.member_12, _e4774.member_13, _e4774.member_14, _e4774.member_15, _e4774.member_16, _e4774.member_17, _e4774.member_18, _e4774.member_19, _e4774.member_20, _e4774.member_21, _e4774.member_22, _e4774.member_23, _e4774.member_24, _e4774.member_25, _e4774.member_26, _e4774.member_27);
let _e4840 = type_25(_e4812.member, _e4812.member_1, _e4812.member_2, (vec3<f32>(select(0f, _e4545, _e4499), select(0f, _e4546, _e4499), select(0f, _e4547, _e4499)) + vec3<f32>((_e4588 * _e4710), (_e4589 * _e4710), (_e4590 * _e4710))), _e4812.member_4, _e4812.member_5, _e4812.member_6, _e4812.member_7, _e4812.member_8, _e4812.member_9, _e4812.member_10, _e4812.member_11, _e4812.member_12, _e4812.member_13, _e4812.member_14, _e4812.member_15, _e4812.member_16, _e4812.member_17, _e4812.member_18, _e4812.member_19, _e4812.member_20, _e4812.member_21, _e4812.member_22, _e4812.member_23, _e4812.member_24, _e4812.member_25, _e4812.member_26, _e4812.member_27);
let _e4868 = type_25(_e4840.member, _e4840.member_1, _e4840.member_2, _e4840.member_3, vec3<f32>(_e4570, _e4571, _e4572), _e4840.member_5, _e4840.member_6, _e4840.member_7, _e4840.member_8, _e4840.member_9, _e4840.member_10, _e4840.member_11, _e4840.member_12, _e4840.member_13, _e4840.member_14, _e4840.member_15, _e4840.member_16, _e4840.member_17, _e4840.member_18, _e4840.member_19, _e4840.member_20, _e4840.member_21, _e4840.member_22, _e4840.member_23, _e4840.member_24, _e4840.member_25, _e4840.member_26, _e4840.member_27);
let _e4896 = type_25(_e4868.member, _e4868.member_1, _e4868.member_2, _e4868.member_3, _e4868.member_4, vec3<f32>(_e4588, _e4589, _e4590), _e4868.member_6, _e4868.member_7, _e4868.member_8, _e4868.member_9, _e4868.member_10, _e4868.member_11, _e4868.member_12, _e4868.member_13, _e4868.member_14, _e4868.member_15, _e4868.member_16, _e4868.member_17, _e4868.member_18, _e4868.member_19, _e4868.member_20, _e4868.member_21, _e4868.member_22, _e4868.member_23, _e4868.member_24, _e4868.member_25, _e4868.member_26, _e4868.member_27);
let _e4924 = type_25(_e4896.member, _e4896.member_1, _e4896.member_2, _e4896.member_3, _e4896.member_4, _e4896.member_5, _e4896.member_6, 0i, _e4896.member_8, _e4896.member_9, _e4896.member_10, _e4896.member_11, _e4896.member_12, _e4896.member_13, _e4896.member_14, _e4896.member_15, _e4896.member_16, _e4896.member_17, _e4896.member_18, _e4896.member_19, _e4896.member_20, _e4896.member_21, _e4896.member_22, _e4896.member_23, _e4896.member_24, _e4896.member_25, _e4896.member_26, _e4896.member_27);
let _e4952 = type_25(_e4924.member, _e4924.member_1, _e4924.member_2, _e4924.member_3, _e4924.member_4, _e4924.member_5, _e4924.member_6, _e4924.member_7, _e4924.member_8, _e4924.member_9, _e4924.member_10, _e4924.member_11, _e4924.member_12, _e4924.member_13, _e4924.member_14, _e4924.member_15, 0i, _e4924.member_17, _e4924.member_18, _e4924.member_19, _e4924.member_20, _e4924.member_21, _e4924.member_22, _e4924.member_23, _e4924.member_24, _e4924.member_25, _e4924.member_26, _e4924.member_27);
let _e4980 = type_25(_e4952.member, _e4952.member_1, _e4952.member_2, _e4952.member_3, _e4952.member_4, _e4952.member_5, _e4952.member_6, _e4952.member_7, _e4952.member_8, _e4952.member_9, _e4952.member_10, _e4952.member_11, _e4952.member_12, _e4952.member_13, _e4952.member_14, 1f, _e4952.member_16, _e4952.member_17, _e4952.member_18, _e4952.member_19, _e4952.member_20, _e4952.member_21, _e4952.member_22, _e4952.member_23, _e4952.member_24, _e4952.member_25, _e4952.member_26, _e4952.member_27);
let _e4986 = ((((_e4009.member.member * _e4714) + (_e4009.member.member_1 * _e4715)) + (_e4009.member.member_2 * _e4716)) + _e4009.member_1);
let _e4990 = ((_e4986 / _e4677) - 0.015625f);
let _e4993 = select(1e30f, select(0f, _e4990, (_e4990 > 0f)), ((_e4986 > 0f) && _e4675));
let _e4999 = ((((_e4046.member.member * _e4714) + (_e4046.member.member_1 * _e4715)) + (_e4046.member.member_2 * _e4716)) + _e4046.member_1);
let _e5003 = ((_e4999 / _e4698) - 0.015625f);
let _e5006 = select(1e30f, select(0f, _e5003, (_e5003 > 0f)), ((_e4999 > 0f) && _e4696));
let _e5010 = (_e5006 < _e4993);
let _e5041 = type_25(_e4980.member, _e4980.member_1, _e4980.member_2, _e4980.member_3, _e4980.member_4, _e4980.member_5, _e4980.member_6, _e4980.member_7, 0i, _e4980.member_9, _e4980.member_10, _e4980.member_11, _e4980.member_12, _e4980.member_13, _e4980.member_14, _e4980.member_15, _e4980.member_16, _e4980.member_17, _e4980.member_18, _e4980.member_19, _e4980.member_20, _e4980.member_21, _e4980.member_22, _e4980.member_23, _e4980.member_24, _e4980.member_25, _e4980.member_26, _e4980.member_27);
let _e5069 = type_25(_e5041.member, _e5041.member_1, _e5041.member_2, _e5041.member_3, _e5041.member_4, _e5041.member_5, _e5041.member_6, _e5041.member_7, _e5041.member_8, select(select(-2i, -3i, _e5010), -1i, ((_e4993 >= 1e30f) && (_e5006 >= 1e30f))), _e5041.member_10, _e5041.member_11, _e5041.member_12, _e5041.member_13, _e5041.member_14, _e5041.member_15, _e5041.member_16, _e5041.member_17, _e5041.member_18, _e5041.member_19, _e5041.member_20, _e5041.member_21, _e5041.member_22, _e5041.member_23, _e5041.member_24, _e5041.member_25, _e5041.member_26, _e5041.member_27);
let _e5097 = type_25(_e5069.member, _e5069.member_1, _e5069.member_2, _e5069.member_3, _e5069.member_4, _e5069.member_5, _e5069.member_6, _e5069.member_7, _e5069.member_8, _e5069.member_9, select(_e4993, _e5006, _e5010), _e5069.member_11, _e5069.member_12, _e5069.member_13, _e5069.member_14, _e5069.member_15, _e5069.member_16, _e5069.member_17, _e5069.member_18, _e5069.member_19, _e5069.member_20, _e5069.member_21, _e5069.member_22, _e5069.member_23, _e5069.member_24, _e5069.member_25, _e5069.member_26, _e5069.member_27);
let _e5125 = type_25(_e5097.member, _e5097.member_1, _e5097.member_2, _e5097.member_3, _e5097.member_4, _e5097.member_5, _e5097.member_6, _e5097.member_7, _e5097.member_8, _e5097.member_9, _e5097.member_10, _e5097.member_11, _e5097.member_12, 0f, _e5097.member_14, _e5097.member_15, _e5097.member_16, _e5097.member_17, _e5097.member_18, _e5097.member_19, _e5097.member_20, _e5097.member_21, _e5097.member_22, _e5097.member_23, _e5097.member_24, _e5097.member_25, _e5097.member_26, _e5097.member_27);
let _e5153 = type_25(_e5125.member, _e5125.member_1, _e5125.member_2, _e5125.member_3, _e5125.member_4, _e5125.member_5, _e5125.member_6, _e5125.member_7, _e5125.member_8, _e5125.member_9, _e5125.member_10, 0i, _e5125.member_12, _e5125.member_13, _e5125.member_14, _e5125.member_15, _e5125.member_16, _e5125.member_17, _e5125.member_18, _e5125.member_19, _e5125.member_20, _e5125.member_21, _e5125.member_22, _e5125.member_23, _e5125.member_24, _e5125.member_25, _e5125.member_26, _e5125.member_27);
let _e5181 = type_25(_e5153.member, _e5153.member_1, _e5153.member_2, _e5153.member_3, _e5153.member_4, _e5153.member_5, _e5153.member_6, _e5153.member_7, _e5153.member_8, _e5153.member_9, _e5153.member_10, _e5153.member_11, 0i, _e5153.member_13, _e5153.member_14, _e5153.member_15, _e5153.member_16, _e5153.member_17, _e5153.member_18, _e5153.member_19, _e5153.member_20, _e5153.member_21, _e5153.member_22, _e5153.member_23, _e5153.member_24, _e5153.member_25, _e5153.member_26, _e5153.member_27);
let _e5185 = global_5.member.member_13.member_4;
let _e5192 = global_5.member.member_13.member_5;
let _e5197 = ((_e5185.member - _e4521) * _e4599);
let _e5199 = ((_e5192.member - _e4521) * _e4599);
let _e5201 = ((_e5185.member_1 - _e4522) * _e4607);
let _e5203 = ((_e5192.member_1 - _e4522) * _e4607);
let _e5205 = ((_e5185.member_2 - _e4523) * _e4615);
let _e5207 = ((_e5192.member_2 - _e4523) * _e4615);
let _e5209 = select(_e5199, _e5197, (_e5197 < _e5199));
let _e5211 = select(_e5203, _e5201, (_e5201 < _e5203));
let _e5213 = select(_e5211, _e5209, (_e5209 > _e5211));
let _e5215 = select(_e5207, _e5205, (_e5205 < _e5207));
let _e5217 = select(_e5215, _e5213, (_e5213 > _e5215));
let _e5219 = select(_e5199, _e5197, (_e5197 > _e5199));
let _e5221 = select(_e5203, _e5201, (_e5201 > _e5203));
let _e5223 = select(_e5221, _e5219, (_e5219 < _e5221));
let _e5225 = select(_e5207, _e5205, (_e5205 > _e5207));
let _e5227 = select(_e5225, _e5223, (_e5223 < _e5225));
let _e5229 = select(0f, _e5217, (_e5217 > 0f));
let _e5231 = select(_e4710, _e5227, (_e5227 < _e4710));
let _e5234 = (select(_e5229, _e5231, (_e5231 > _e5229)) - _e5229);
let _e5238 = global_5.member.member_13.member;
let _e5243 = -((_e5238.member * _e5234));
let _e5245 = select(-87f, _e5243, (_e5243 > -87f));
let _e5247 = select(88f, _e5245, (_e5245 < 88f));
let _e5249 = ((_e5247 * 1.442695f) + 0.5f);
let _e5251 = select(-127f, _e5249, (_e5249 > -127f));
let _e5253 = select(128f, _e5251, (_e5251 < 128f));
let _e5260 = select(0i, select(select(i32(_e5253), i32(-2147483648), (_e5253 < -2147483600f)), 2147483647i, (_e5253 > 2147483500f)), (_e5253 == _e5253));
let _e5264 = (_e5260 - select(0i, 1i, (_e5253 < f32(_e5260))));
let _e5265 = f32(_e5264);
let _e5269 = ((_e5247 - (_e5265 * 0.6933594f)) - (_e5265 * -2.1219444e-4f));
let _e5291 = -((_e5238.member_1 * _e5234));
let _e5293 = select(-87f, _e5291, (_e5291 > -87f));
let _e5295 = select(88f, _e5293, (_e5293 < 88f));
let _e5297 = ((_e5295 * 1.442695f) + 0.5f);
let _e5299 = select(-127f, _e5297, (_e5297 > -127f));
let _e5301 = select(128f, _e5299, (_e5299 < 128f));
let _e5308 = select(0i, select(select(i32(_e5301), i32(-2147483648), (_e5301 < -2147483600f)), 2147483647i, (_e5301 > 2147483500f)), (_e5301 == _e5301));
let _e5312 = (_e5308 - select(0i, 1i, (_e5301 < f32(_e5308))));
let _e5313 = f32(_e5312);
let _e5317 = ((_e5295 - (_e5313 * 0.6933594f)) - (_e5313 * -2.1219444e-4f));
let _e5339 = -((_e5238.member_2 * _e5234));
let _e5341 = select(-87f, _e5339, (_e5339 > -87f));
let _e5343 = select(88f, _e5341, (_e5341 < 88f));
let _e5345 = ((_e5343 * 1.442695f) + 0.5f);
let _e5347 = select(-127f, _e5345, (_e5345 > -127f));
let _e5349 = select(128f, _e5347, (_e5347 < 128f));
let _e5356 = select(0i, select(select(i32(_e5349), i32(-2147483648), (_e5349 < -2147483600f)), 2147483647i, (_e5349 > 2147483500f)), (_e5349 == _e5349));
let _e5360 = (_e5356 - select(0i, 1i, (_e5349 < f32(_e5356))));
let _e5361 = f32(_e5360);
let _e5365 = ((_e5343 - (_e5361 * 0.6933594f)) - (_e5361 * -2.1219444e-4f));
let _e5388 = (1f / 3f);
let _e5390 = (1f * ((1f + (_e5269 * (1f + (_e5269 * (0.5f + (_e5269 * (0.16666667f + (_e5269 * (0.041666668f + (_e5269 * (0.008333334f + (_e5269 * (0.001388889f + (_e5269 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e5264 + 127i)) << bitcast<u32>(23i)))));
let _e5391 = (1f * ((1f + (_e5317 * (1f + (_e5317 * (0.5f + (_e5317 * (0.16666667f + (_e5317 * (0.041666668f + (_e5317 * (0.008333334f + (_e5317 * (0.001388889f + (_e5317 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e5312 + 127i)) << bitcast<u32>(23i)))));
let _e5392 = (1f * ((1f + (_e5365 * (1f + (_e5365 * (0.5f + (_e5365 * (0.16666667f + (_e5365 * (0.041666668f + (_e5365 * (0.008333334f + (_e5365 * (0.001388889f + (_e5365 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e5360 + 127i)) << bitcast<u32>(23i)))));
let _e5421 = type_25(_e5181.member, _e5181.member_1, _e5181.member_2, _e5181.member_3, _e5181.member_4, _e5181.member_5, vec3<f32>(_e5390, _e5391, _e5392), _e5181.member_7, _e5181.member_8, _e5181.member_9, _e5181.member_10, _e5181.member_11, _e5181.member_12, _e5181.member_13, _e5181.member_14, _e5181.member_15, _e5181.member_16, _e5181.member_17, _e5181.member_18, _e5181.member_19, _e5181.member_20, _e5181.member_21, _e5181.member_22, _e5181.member_23, _e5181.member_24, _e5181.member_25, _e5181.member_26, _e5181.member_27);
if (bitcast<i32>(countOneBits(0u)) == _e4439.member_20) {
phi_9370_ = ((((1f + 1f) + 1f) * _e5388) - (((_e5390 + _e5391) + _e5392) * _e5388));
} else {
phi_9370_ = 0f;
}
let _e5431 = phi_9370_;
let _e5461 = type_25(_e5421.member, _e5421.member_1, _e5421.member_2, _e5421.member_3, _e5421.member_4, _e5421.member_5, _e5421.member_6, _e5421.member_7, _e5421.member_8, _e5421.member_9, _e5421.member_10, _e5421.member_11, _e5421.member_12, _e5421.member_13, _e5421.member_14, _e5421.member_15, _e5421.member_16, _e5421.member_17, _e5421.member_18, _e5421.member_19, _e5421.member_20, _e5421.member_21, _e5421.member_22, _e5421.member_23, _e5421.member_24, _e5421.member_25, (_e4439.member_26 + _e5431), _e5421.member_27);
if _e4709 {
phi_9397_ = type_25(_e5461.member, _e5461.member_1, _e5461.member_2, _e5461.member_3, _e5461.member_4, _e5461.member_5, _e5461.member_6, _e5461.member_7, _e1380, _e5461.member_9, _e5461.member_10, _e5461.member_11, _e5461.member_12, _e5461.member_13, _e5461.member_14, _e5461.member_15, _e5461.member_16, _e5461.member_17, _e5461.member_18, _e5461.member_19, _e5461.member_20, _e5461.member_21, _e5461.member_22, _e5461.member_23, _e5461.member_24, _e5461.member_25, _e5461.member_26, _e5461.member_27);
} else {
phi_9397_ = _e5461;
}
let _e5491 = phi_9397_;
phi_9398_ = _e5491;
}
let _e5521 = phi_9398_;
phi_9399_ = _e5521;
} else {
phi_9399_ = _e4163;
}
let _e5523 = phi_9399_;
phi_9400_ = type_25();
phi_9401_ = _e5523;
}
let _e5801 = phi_9400_;
let _e5803 = phi_9401_;
phi_9402_ = _e5801;
phi_9403_ = _e5803;
phi_9404_ = _e2118;
}
let _e7213 = phi_9402_;
let _e7215 = phi_9403_;
let _e7217 = phi_9404_;
if _e7217 {
phi_9408_ = _e7213;
} else {
phi_9408_ = _e7215;
}
let _e7219 = phi_9408_;
phi_9409_ = _e7219;
}
let _e7279 = phi_9409_;
phi_9411_ = _e7279;
phi_9412_ = select(false, _e1418, _e1461);
}
let _e8135 = phi_9411_;
let _e8137 = phi_9412_;
phi_2425_ = _e8135;
phi_2428_ = (_e1416 + 1i);
phi_2430_ = _e8137;
} else {
phi_2425_ = type_25();
phi_2428_ = i32();
phi_2430_ = bool();
}
let _e8139 = phi_2425_;
let _e8141 = phi_2428_;
let _e8143 = phi_2430_;
continue;
continuing {
phi_2424_ = _e8139;
phi_2427_ = _e8141;
phi_2429_ = _e8143;
break if !(_e1422);
}
}
let _e8146 = local_10;
let _e8150 = local_11;
let _e8154 = local_12;
let _e8158 = local_13;
let _e8162 = local_14;
let _e8166 = local_15;
let _e8170 = local_16;
let _e8174 = local_17;
let _e8178 = local_18;
let _e8182 = local_19;
let _e8186 = local_20;
let _e8190 = local_21;
let _e8194 = local_22;
let _e8198 = local_23;
let _e8202 = local_24;
let _e8206 = local_25;
let _e8210 = local_26;
let _e8214 = local_27;
let _e8218 = local_28;
let _e8222 = local_29;
let _e8226 = local_30;
let _e8230 = local_31;
let _e8234 = local_32;
let _e8238 = local_33;
let _e8242 = local_34;
let _e8245 = local_35;
let _e8249 = local_36;
let _e8253 = local_37;
let _e8256 = local_38;
let _e8259 = local_39;
let _e8263 = local_40;
let _e8267 = local_41;
let _e8271 = local_42;
let _e8275 = local_43;
let _e8279 = local_44;
let _e8283 = local_45;
let _e8287 = local_46;
let _e8290 = local_47;
let _e8293 = local_48;
let _e8296 = local_49;
let _e8299 = local_50;
global_4.member[_e143] = _e8146.member.x;
global_4.member[_e155] = _e8150.member.y;
global_4.member[_e166] = _e8154.member.z;
global_4.member[_e177] = _e8158.member_1.x;
global_4.member[_e188] = _e8162.member_1.y;
global_4.member[_e199] = _e8166.member_1.z;
global_4.member[_e210] = _e8170.member_2.x;
global_4.member[_e221] = _e8174.member_2.y;
global_4.member[_e232] = _e8178.member_2.z;
global_4.member[_e243] = _e8182.member_3.x;
global_4.member[_e254] = _e8186.member_3.y;
global_4.member[_e265] = _e8190.member_3.z;
global_4.member[_e276] = _e8194.member_4.x;
global_4.member[_e287] = _e8198.member_4.y;
global_4.member[_e298] = _e8202.member_4.z;
global_4.member[_e309] = _e8206.member_5.x;
global_4.member[_e320] = _e8210.member_5.y;
global_4.member[_e331] = _e8214.member_5.z;
global_4.member[_e342] = _e8218.member_6.x;
global_4.member[_e353] = _e8222.member_6.y;
global_4.member[_e364] = _e8226.member_6.z;
global_4.member[_e375] = f32(_e8230.member_7);
global_4.member[_e386] = f32(_e8234.member_8);
global_4.member[_e397] = f32(_e8238.member_9);
global_4.member[_e408] = _e8242.member_10;
global_4.member[_e419] = f32(_e8245.member_11);
global_4.member[_e430] = f32(_e8249.member_12);
global_4.member[_e441] = _e8253.member_13;
global_4.member[_e452] = _e8256.member_14;
let _e8362 = local_51;
global_4.member[_e463] = _e8362;
global_4.member[_e474] = f32(_e8259.member_16);
global_4.member[_e485] = f32(_e8263.member_17);
global_4.member[_e496] = f32(_e8267.member_18);
global_4.member[_e507] = f32(_e8271.member_19);
global_4.member[_e518] = f32(_e8275.member_20);
global_4.member[_e529] = f32(_e8279.member_21);
global_4.member[_e540] = f32(_e8283.member_22);
global_4.member[_e551] = _e8287.member_23;
global_4.member[_e562] = _e8290.member_24;
global_4.member[_e573] = _e8293.member_25;
global_4.member[_e584] = _e8296.member_26;
global_4.member[_e595] = _e8299.member_27;
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
