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
struct type_11 {
member: array<f32>,
}
struct type_15 {
member: array<u32>,
}
struct type_16 {
member: u32,
member_1: u32,
member_2: u32,
member_3: u32,
}
struct type_17 {
member: u32,
member_1: u32,
}
struct type_18 {
member: f32,
member_1: f32,
member_2: f32,
member_3: f32,
member_4: f32,
member_5: f32,
}
struct type_19 {
member: type_7,
member_1: type_7,
member_2: type_7,
member_3: type_5,
member_4: f32,
member_5: f32,
member_6: f32,
member_7: i32,
member_8: i32,
member_9: type_2,
member_10: u32,
member_11: type_2,
member_12: u32,
}
struct type_20 {
member: u32,
member_1: u32,
member_2: f32,
member_3: f32,
member_4: f32,
member_5: f32,
member_6: f32,
member_7: f32,
member_8: f32,
}
struct type_21 {
member: type_5,
member_1: type_5,
}
struct type_22 {
member: type_7,
member_1: u32,
}
struct type_23 {
member: type_2,
member_1: u32,
member_2: type_16,
member_3: type_17,
member_4: u32,
member_5: type_18,
member_6: type_19,
member_7: type_19,
member_8: type_20,
member_9: type_21,
member_10: f32,
member_11: type_18,
member_12: type_4,
member_13: type_9,
member_14: type_22,
member_15: type_22,
member_16: type_22,
member_17: type_22,
member_18: type_5,
member_19: f32,
member_20: f32,
member_21: type_6,
}
struct type_24 {
member: type_23,
}
struct type_27 {
member: array<i32, 4>,
member_1: array<u32, 6>,
}
struct type_28 {
member: f32,
member_1: vec3<f32>,
member_2: vec3<f32>,
}
struct type_29 {
member: f32,
member_1: vec3<f32>,
member_2: f32,
member_3: vec3<f32>,
member_4: vec3<f32>,
}
struct type_30 {
member: f32,
member_1: f32,
member_2: vec3<f32>,
member_3: vec3<f32>,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_24;
@group(0) @binding(1)
var<storage> global_2: type_15;
@group(0) @binding(3)
var<storage> global_3: type_15;
@group(0) @binding(4)
var<storage> global_4: type_15;
@group(0) @binding(6)
var<storage, read_write> global_5: type_11;
@group(0) @binding(5)
var<storage> global_6: type_11;
@group(0) @binding(2)
var<storage> global_7: type_15;
fn function_() {
var local: type_27;
var local_1: vec3<f32>;
var local_2: type_27;
var local_3: vec3<f32>;
var local_4: type_27;
var local_5: vec3<f32>;
var local_6: type_27;
var local_7: vec3<f32>;
var phi_1244_: u32;
var phi_4622_: type_28;
var phi_5231_: type_29;
var phi_6027_: type_5;
var phi_7137_: type_30;
var phi_7288_: f32;
var phi_7289_: f32;
var phi_7290_: f32;
var phi_7291_: f32;
let _e87 = global;
let _e90 = arrayLength((&global_2.member));
let _e97 = arrayLength((&global_4.member));
let _e99 = arrayLength((&global_6.member));
let _e104 = global_1.member.member_2;
let _e107 = global_1.member.member;
let _e115 = (_e87.x + _e104.member);
let _e117 = (_e87.y + _e104.member_1);
if (_e115 < _e104.member_2) {
if (_e117 < _e104.member_3) {
let _e120 = (_e107.member * _e107.member_1);
let _e122 = ((_e117 * _e107.member) + _e115);
let _e123 = bitcast<i32>(_e122);
let _e125 = (bitcast<i32>(arrayLength((&global_5.member))) - 1i);
let _e127 = select(_e125, _e123, (_e123 < _e125));
let _e133 = global_5.member[bitcast<u32>(select(0i, _e127, (_e127 > 0i)))];
let _e134 = (_e120 + _e122);
let _e135 = bitcast<i32>(_e134);
let _e137 = select(_e125, _e135, (_e135 < _e125));
let _e143 = global_5.member[bitcast<u32>(select(0i, _e137, (_e137 > 0i)))];
let _e145 = ((2u * _e120) + _e122);
let _e146 = bitcast<i32>(_e145);
let _e148 = select(_e125, _e146, (_e146 < _e125));
let _e154 = global_5.member[bitcast<u32>(select(0i, _e148, (_e148 > 0i)))];
let _e156 = ((3u * _e120) + _e122);
let _e157 = bitcast<i32>(_e156);
let _e159 = select(_e125, _e157, (_e157 < _e125));
let _e165 = global_5.member[bitcast<u32>(select(0i, _e159, (_e159 > 0i)))];
let _e167 = ((4u * _e120) + _e122);
let _e168 = bitcast<i32>(_e167);
let _e170 = select(_e125, _e168, (_e168 < _e125));
let _e176 = global_5.member[bitcast<u32>(select(0i, _e170, (_e170 > 0i)))];
let _e178 = ((5u * _e120) + _e122);
let _e179 = bitcast<i32>(_e178);
let _e181 = select(_e125, _e179, (_e179 < _e125));
let _e187 = global_5.member[bitcast<u32>(select(0i, _e181, (_e181 > 0i)))];
let _e189 = ((6u * _e120) + _e122);
let _e190 = bitcast<i32>(_e189);
let _e192 = select(_e125, _e190, (_e190 < _e125));
let _e198 = global_5.member[bitcast<u32>(select(0i, _e192, (_e192 > 0i)))];
let _e200 = ((7u * _e120) + _e122);
let _e201 = bitcast<i32>(_e200);
let _e203 = select(_e125, _e201, (_e201 < _e125));
let _e209 = global_5.member[bitcast<u32>(select(0i, _e203, (_e203 > 0i)))];
let _e211 = ((8u * _e120) + _e122);
let _e212 = bitcast<i32>(_e211);
let _e214 = select(_e125, _e212, (_e212 < _e125));
let _e220 = global_5.member[bitcast<u32>(select(0i, _e214, (_e214 > 0i)))];
let _e224 = global_1.member.member_8.member;
let _e228 = global_1.member.member_8.member_1;
let _e229 = (_e224 * _e228);
if (_e99 >= (_e229 * 2u)) {
let _e233 = bitcast<i32>((_e117 * _e224));
let _e235 = bitcast<i32>(_e115);
let _e240 = global_6.member[bitcast<u32>((_e233 + _e235))];
let _e246 = global_6.member[bitcast<u32>(((bitcast<i32>(_e229) + _e233) + _e235))];
let _e247 = f32(_e235);
let _e249 = f32(bitcast<i32>(_e117));
let _e255 = global_1.member.member_5.member;
let _e259 = global_1.member.member_8.member_8;
let _e260 = (_e255 - _e259);
let _e264 = global_1.member.member_8.member_2;
let _e268 = global_1.member.member_8.member_6;
let _e275 = global_1.member.member_8.member_4;
let _e277 = ((_e264 + (_e268 * _e260)) + (((_e247 - _e240) + 0.5f) * _e275));
let _e281 = global_1.member.member_8.member_3;
let _e285 = global_1.member.member_8.member_7;
let _e290 = ((_e281 + (_e285 * _e260)) + (((_e249 - _e246) + 0.5f) * _e275));
let _e294 = global_1.member.member_5.member_1;
let _e295 = (_e294 - _e259);
let _e300 = ((_e264 + (_e268 * _e295)) + ((_e247 + 0.5f) * _e275));
let _e305 = ((_e281 + (_e285 * _e295)) + ((_e249 + 0.5f) * _e275));
let _e309 = global_1.member.member_6.member;
let _e320 = ((((_e309.member.member * _e277) + (_e309.member.member_1 * _e290)) + (_e309.member.member_2 * _e255)) + _e309.member_1);
let _e324 = global_1.member.member_6.member_1;
let _e335 = ((((_e324.member.member * _e277) + (_e324.member.member_1 * _e290)) + (_e324.member.member_2 * _e255)) + _e324.member_1);
let _e339 = global_1.member.member_6.member_2;
let _e350 = ((((_e339.member.member * _e277) + (_e339.member.member_1 * _e290)) + (_e339.member.member_2 * _e255)) + _e339.member_1);
let _e356 = ((((_e309.member.member * _e300) + (_e309.member.member_1 * _e305)) + (_e309.member.member_2 * _e294)) + _e309.member_1);
let _e362 = ((((_e324.member.member * _e300) + (_e324.member.member_1 * _e305)) + (_e324.member.member_2 * _e294)) + _e324.member_1);
let _e368 = ((((_e339.member.member * _e300) + (_e339.member.member_1 * _e305)) + (_e339.member.member_2 * _e294)) + _e339.member_1);
let _e374 = global_1.member.member_6.member_3.member;
let _e375 = (_e374 - 1f);
let _e384 = global_1.member.member_6.member_3.member_1;
let _e385 = (_e384 - 1f);
let _e394 = global_1.member.member_6.member_3.member_2;
let _e395 = (_e394 - 1f);
let _e414 = global_1.member.member_6.member_4;
let _e415 = (_e374 - 0.5f);
let _e417 = select(-0.5f, _e356, (_e356 > -0.5f));
let _e419 = select(_e415, _e417, (_e417 < _e415));
let _e420 = (_e384 - 0.5f);
let _e422 = select(-0.5f, _e362, (_e362 > -0.5f));
let _e424 = select(_e420, _e422, (_e422 < _e420));
let _e425 = (_e394 - 0.5f);
let _e427 = select(-0.5f, _e368, (_e368 > -0.5f));
let _e429 = select(_e425, _e427, (_e427 < _e425));
let _e435 = bitcast<f32>((bitcast<u32>((_e356 - _e320)) & 2147483647u));
let _e438 = bitcast<f32>((bitcast<u32>((_e362 - _e335)) & 2147483647u));
let _e440 = select(_e438, _e435, (_e435 > _e438));
let _e443 = bitcast<f32>((bitcast<u32>((_e368 - _e350)) & 2147483647u));
let _e452 = bitcast<f32>((bitcast<u32>((_e356 - _e419)) & 2147483647u));
let _e455 = bitcast<f32>((bitcast<u32>((_e362 - _e424)) & 2147483647u));
let _e457 = select(_e455, _e452, (_e452 > _e455));
let _e460 = bitcast<f32>((bitcast<u32>((_e368 - _e429)) & 2147483647u));
let _e464 = (_e419 + 0.5f);
let _e466 = select(0f, _e464, (_e464 > 0f));
let _e468 = select(_e375, _e466, (_e466 < _e375));
let _e475 = select(0i, select(select(i32(_e468), i32(-2147483648), (_e468 < -2147483600f)), 2147483647i, (_e468 > 2147483500f)), (_e468 == _e468));
let _e483 = global_1.member.member_6.member_12;
let _e484 = (_e483 & 31u);
let _e487 = (_e424 + 0.5f);
let _e489 = select(0f, _e487, (_e487 > 0f));
let _e491 = select(_e385, _e489, (_e489 < _e385));
let _e498 = select(0i, select(select(i32(_e491), i32(-2147483648), (_e491 < -2147483600f)), 2147483647i, (_e491 > 2147483500f)), (_e491 == _e491));
let _e505 = (_e429 + 0.5f);
let _e507 = select(0f, _e505, (_e505 > 0f));
let _e509 = select(_e395, _e507, (_e507 < _e395));
let _e516 = select(0i, select(select(i32(_e509), i32(-2147483648), (_e509 < -2147483600f)), 2147483647i, (_e509 > 2147483500f)), (_e509 == _e509));
let _e527 = global_1.member.member_6.member_9.member;
let _e533 = global_1.member.member_6.member_9.member_1;
let _e538 = global_1.member.member_6.member_10;
let _e544 = ((bitcast<i32>(_e538) + ((_e475 - select(0i, 1i, (_e468 < f32(_e475)))) >> bitcast<u32>(_e484))) + (bitcast<i32>(_e527) * (((_e498 - select(0i, 1i, (_e491 < f32(_e498)))) >> bitcast<u32>(_e484)) + (bitcast<i32>(_e533) * ((_e516 - select(0i, 1i, (_e509 < f32(_e516)))) >> bitcast<u32>(_e484))))));
let _e546 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e548 = select(_e546, _e544, (_e544 < _e546));
let _e554 = global_3.member[bitcast<u32>(select(0i, _e548, (_e548 > 0i)))];
let _e561 = global_1.member.member_7.member;
let _e576 = global_1.member.member_7.member_1;
let _e591 = global_1.member.member_7.member_2;
let _e608 = ((((_e561.member.member * _e300) + (_e561.member.member_1 * _e305)) + (_e561.member.member_2 * _e294)) + _e561.member_1);
let _e614 = ((((_e576.member.member * _e300) + (_e576.member.member_1 * _e305)) + (_e576.member.member_2 * _e294)) + _e576.member_1);
let _e620 = ((((_e591.member.member * _e300) + (_e591.member.member_1 * _e305)) + (_e591.member.member_2 * _e294)) + _e591.member_1);
let _e624 = global_1.member.member_7.member_4;
let _e629 = global_1.member.member_7.member_3.member;
let _e630 = (_e629 - 0.5f);
let _e632 = select(-0.5f, _e608, (_e608 > -0.5f));
let _e634 = select(_e630, _e632, (_e632 < _e630));
let _e639 = global_1.member.member_7.member_3.member_1;
let _e640 = (_e639 - 0.5f);
let _e642 = select(-0.5f, _e614, (_e614 > -0.5f));
let _e644 = select(_e640, _e642, (_e642 < _e640));
let _e649 = global_1.member.member_7.member_3.member_2;
let _e650 = (_e649 - 0.5f);
let _e652 = select(-0.5f, _e620, (_e620 > -0.5f));
let _e654 = select(_e650, _e652, (_e652 < _e650));
let _e660 = bitcast<f32>((bitcast<u32>((_e608 - ((((_e561.member.member * _e277) + (_e561.member.member_1 * _e290)) + (_e561.member.member_2 * _e255)) + _e561.member_1))) & 2147483647u));
let _e663 = bitcast<f32>((bitcast<u32>((_e614 - ((((_e576.member.member * _e277) + (_e576.member.member_1 * _e290)) + (_e576.member.member_2 * _e255)) + _e576.member_1))) & 2147483647u));
let _e665 = select(_e663, _e660, (_e660 > _e663));
let _e668 = bitcast<f32>((bitcast<u32>((_e620 - ((((_e591.member.member * _e277) + (_e591.member.member_1 * _e290)) + (_e591.member.member_2 * _e255)) + _e591.member_1))) & 2147483647u));
let _e677 = bitcast<f32>((bitcast<u32>((_e608 - _e634)) & 2147483647u));
let _e680 = bitcast<f32>((bitcast<u32>((_e614 - _e644)) & 2147483647u));
let _e682 = select(_e680, _e677, (_e677 > _e680));
let _e685 = bitcast<f32>((bitcast<u32>((_e620 - _e654)) & 2147483647u));
let _e689 = (_e634 + 0.5f);
let _e690 = (_e629 - 1f);
let _e692 = select(0f, _e689, (_e689 > 0f));
let _e694 = select(_e690, _e692, (_e692 < _e690));
let _e701 = select(0i, select(select(i32(_e694), i32(-2147483648), (_e694 < -2147483600f)), 2147483647i, (_e694 > 2147483500f)), (_e694 == _e694));
let _e709 = global_1.member.member_7.member_12;
let _e710 = (_e709 & 31u);
let _e713 = (_e644 + 0.5f);
let _e714 = (_e639 - 1f);
let _e716 = select(0f, _e713, (_e713 > 0f));
let _e718 = select(_e714, _e716, (_e716 < _e714));
let _e725 = select(0i, select(select(i32(_e718), i32(-2147483648), (_e718 < -2147483600f)), 2147483647i, (_e718 > 2147483500f)), (_e718 == _e718));
let _e732 = (_e654 + 0.5f);
let _e733 = (_e649 - 1f);
let _e735 = select(0f, _e732, (_e732 > 0f));
let _e737 = select(_e733, _e735, (_e735 < _e733));
let _e744 = select(0i, select(select(i32(_e737), i32(-2147483648), (_e737 < -2147483600f)), 2147483647i, (_e737 > 2147483500f)), (_e737 == _e737));
let _e755 = global_1.member.member_7.member_9.member;
let _e761 = global_1.member.member_7.member_9.member_1;
let _e766 = global_1.member.member_7.member_10;
let _e772 = ((bitcast<i32>(_e766) + ((_e701 - select(0i, 1i, (_e694 < f32(_e701)))) >> bitcast<u32>(_e710))) + (bitcast<i32>(_e755) * (((_e725 - select(0i, 1i, (_e718 < f32(_e725)))) >> bitcast<u32>(_e710)) + (bitcast<i32>(_e761) * ((_e744 - select(0i, 1i, (_e737 < f32(_e744)))) >> bitcast<u32>(_e710))))));
let _e774 = select(_e546, _e772, (_e772 < _e546));
let _e780 = global_3.member[bitcast<u32>(select(0i, _e774, (_e774 > 0i)))];
let _e786 = global_1.member.member_1;
phi_1244_ = select(select(7u, 3u, (((((((_e320 >= 0f) && (_e320 <= _e375)) && (_e335 >= 0f)) && (_e335 <= _e385)) && (_e350 >= 0f)) && (_e350 <= _e395)) && ((((((_e356 >= 0f) && (_e356 <= _e375)) && (_e362 >= 0f)) && (_e362 <= _e385)) && (_e368 >= 0f)) && (_e368 <= _e395)))), 1u, (((_e786 & 64u) != 0u) || ((((select(_e443, _e440, (_e440 > _e443)) <= _e414) && ((select(_e460, _e457, (_e457 > _e460)) > _e414) || (_e554 != 0u))) && ((select(_e668, _e665, (_e665 > _e668)) <= _e624) && ((select(_e685, _e682, (_e682 > _e685)) > _e624) || (_e780 != 0u)))) && ((_e786 & 32u) != 0u))));
} else {
phi_1244_ = 7u;
}
let _e796 = phi_1244_;
if (_e796 > 1u) {
let _e801 = bitcast<i32>(((_e117 * _e224) + _e115));
let _e804 = (bitcast<i32>(_e99) - 1i);
let _e806 = select(_e804, _e801, (_e801 < _e804));
let _e812 = global_6.member[bitcast<u32>(select(0i, _e806, (_e806 > 0i)))];
let _e813 = (bitcast<i32>(_e229) + _e801);
let _e815 = select(_e804, _e813, (_e813 < _e804));
let _e821 = global_6.member[bitcast<u32>(select(0i, _e815, (_e815 > 0i)))];
let _e823 = f32(bitcast<i32>(_e115));
let _e825 = f32(bitcast<i32>(_e117));
let _e831 = global_1.member.member_5.member;
let _e835 = global_1.member.member_8.member_8;
let _e836 = (_e831 - _e835);
let _e840 = global_1.member.member_8.member_2;
let _e844 = global_1.member.member_8.member_6;
let _e851 = global_1.member.member_8.member_4;
let _e853 = ((_e840 + (_e844 * _e836)) + (((_e823 - _e812) + 0.5f) * _e851));
let _e857 = global_1.member.member_8.member_3;
let _e861 = global_1.member.member_8.member_7;
let _e866 = ((_e857 + (_e861 * _e836)) + (((_e825 - _e821) + 0.5f) * _e851));
let _e870 = global_1.member.member_5.member_1;
let _e871 = (_e870 - _e835);
let _e876 = ((_e840 + (_e844 * _e871)) + ((_e823 + 0.5f) * _e851));
let _e881 = ((_e857 + (_e861 * _e871)) + ((_e825 + 0.5f) * _e851));
let _e885 = global_1.member.member_6.member;
let _e896 = ((((_e885.member.member * _e853) + (_e885.member.member_1 * _e866)) + (_e885.member.member_2 * _e831)) + _e885.member_1);
let _e900 = global_1.member.member_6.member_1;
let _e911 = ((((_e900.member.member * _e853) + (_e900.member.member_1 * _e866)) + (_e900.member.member_2 * _e831)) + _e900.member_1);
let _e915 = global_1.member.member_6.member_2;
let _e926 = ((((_e915.member.member * _e853) + (_e915.member.member_1 * _e866)) + (_e915.member.member_2 * _e831)) + _e915.member_1);
let _e932 = ((((_e885.member.member * _e876) + (_e885.member.member_1 * _e881)) + (_e885.member.member_2 * _e870)) + _e885.member_1);
let _e938 = ((((_e900.member.member * _e876) + (_e900.member.member_1 * _e881)) + (_e900.member.member_2 * _e870)) + _e900.member_1);
let _e944 = ((((_e915.member.member * _e876) + (_e915.member.member_1 * _e881)) + (_e915.member.member_2 * _e870)) + _e915.member_1);
let _e948 = global_1.member.member_7.member;
let _e959 = ((((_e948.member.member * _e876) + (_e948.member.member_1 * _e881)) + (_e948.member.member_2 * _e870)) + _e948.member_1);
let _e963 = global_1.member.member_7.member_1;
let _e974 = ((((_e963.member.member * _e876) + (_e963.member.member_1 * _e881)) + (_e963.member.member_2 * _e870)) + _e963.member_1);
let _e978 = global_1.member.member_7.member_2;
let _e989 = ((((_e978.member.member * _e876) + (_e978.member.member_1 * _e881)) + (_e978.member.member_2 * _e870)) + _e978.member_1);
let _e991 = (_e107.member_2 == 2u);
let _e994 = (((_e107.member_2 == 1u) || _e991) || (_e107.member_2 == 5u));
if _e994 {
let _e999 = global_1.member.member_6.member_3.member;
let _e1000 = (_e999 - 0.5f);
let _e1002 = select(-0.5f, _e932, (_e932 > -0.5f));
let _e1004 = select(_e1000, _e1002, (_e1002 < _e1000));
let _e1009 = global_1.member.member_6.member_3.member_1;
let _e1010 = (_e1009 - 0.5f);
let _e1012 = select(-0.5f, _e938, (_e938 > -0.5f));
let _e1014 = select(_e1010, _e1012, (_e1012 < _e1010));
let _e1019 = global_1.member.member_6.member_3.member_2;
let _e1020 = (_e1019 - 0.5f);
let _e1022 = select(-0.5f, _e944, (_e944 > -0.5f));
let _e1024 = select(_e1020, _e1022, (_e1022 < _e1020));
let _e1026 = select(-1f, _e1004, (_e1004 > -1f));
let _e1028 = select(_e999, _e1026, (_e1026 < _e999));
let _e1035 = select(0i, select(select(i32(_e1028), i32(-2147483648), (_e1028 < -2147483600f)), 2147483647i, (_e1028 > 2147483500f)), (_e1028 == _e1028));
let _e1039 = (_e1035 - select(0i, 1i, (_e1028 < f32(_e1035))));
let _e1041 = select(-1f, _e1014, (_e1014 > -1f));
let _e1043 = select(_e1009, _e1041, (_e1041 < _e1009));
let _e1050 = select(0i, select(select(i32(_e1043), i32(-2147483648), (_e1043 < -2147483600f)), 2147483647i, (_e1043 > 2147483500f)), (_e1043 == _e1043));
let _e1054 = (_e1050 - select(0i, 1i, (_e1043 < f32(_e1050))));
let _e1056 = select(-1f, _e1024, (_e1024 > -1f));
let _e1058 = select(_e1019, _e1056, (_e1056 < _e1019));
let _e1065 = select(0i, select(select(i32(_e1058), i32(-2147483648), (_e1058 < -2147483600f)), 2147483647i, (_e1058 > 2147483500f)), (_e1058 == _e1058));
let _e1069 = (_e1065 - select(0i, 1i, (_e1058 < f32(_e1065))));
let _e1073 = global_1.member.member_6.member_7;
let _e1077 = global_1.member.member_6.member_8;
let _e1078 = (_e1039 + 1i);
let _e1079 = (_e1054 + 1i);
let _e1080 = (_e1069 + 1i);
let _e1085 = global_1.member.member_6.member_11.member;
let _e1091 = global_1.member.member_6.member_11.member_1;
let _e1102 = ((_e1078 >> bitcast<u32>(4i)) + (bitcast<i32>(_e1085) * ((_e1079 >> bitcast<u32>(4i)) + (bitcast<i32>(_e1091) * (_e1080 >> bitcast<u32>(4i))))));
let _e1104 = (bitcast<i32>(_e90) - 1i);
let _e1106 = select(_e1104, _e1102, (_e1102 < _e1104));
let _e1112 = global_2.member[bitcast<u32>(select(0i, _e1106, (_e1106 > 0i)))];
let _e1114 = (_e1078 & 15i);
let _e1117 = ((_e1079 & 15i) * _e1073);
let _e1119 = (bitcast<i32>(_e1112) + ((_e1080 & 15i) * _e1077));
let _e1123 = (_e1117 + _e1073);
let _e1125 = (_e1117 + (2i * _e1073));
let _e1126 = (_e1119 + _e1077);
let _e1128 = (_e1119 + (2i * _e1077));
local_6 = type_27(array<i32, 4>(_e1114, (_e1114 + 1i), (_e1114 + 2i), (_e1114 + 3i)), array<u32, 6>(0u, 16u, 0u, 16u, 0u, 16u));
local_7 = vec3<f32>((_e1004 - f32(_e1039)), (_e1014 - f32(_e1054)), (_e1024 - f32(_e1069)));
let _e1139 = (_e1126 + _e1123);
let _e1142 = local_6.member[1u];
let _e1143 = (_e1139 + _e1142);
let _e1145 = select(_e1104, _e1143, (_e1143 < _e1104));
let _e1150 = global_2.member[bitcast<u32>(select(0i, _e1145, (_e1145 > 0i)))];
let _e1151 = bitcast<f32>(_e1150);
let _e1154 = local_6.member[2u];
let _e1155 = (_e1139 + _e1154);
let _e1157 = select(_e1104, _e1155, (_e1155 < _e1104));
let _e1162 = global_2.member[bitcast<u32>(select(0i, _e1157, (_e1157 > 0i)))];
let _e1164 = local_7[0u];
let _e1167 = (_e1151 + ((bitcast<f32>(_e1162) - _e1151) * _e1164));
let _e1168 = (_e1126 + _e1125);
let _e1169 = local_6.member[1u];
let _e1170 = (_e1168 + _e1169);
let _e1172 = select(_e1104, _e1170, (_e1170 < _e1104));
let _e1177 = global_2.member[bitcast<u32>(select(0i, _e1172, (_e1172 > 0i)))];
let _e1178 = bitcast<f32>(_e1177);
let _e1179 = local_6.member[2u];
let _e1180 = (_e1168 + _e1179);
let _e1182 = select(_e1104, _e1180, (_e1180 < _e1104));
let _e1187 = global_2.member[bitcast<u32>(select(0i, _e1182, (_e1182 > 0i)))];
let _e1189 = local_7[0u];
let _e1193 = (_e1128 + _e1123);
let _e1194 = local_6.member[1u];
let _e1195 = (_e1193 + _e1194);
let _e1197 = select(_e1104, _e1195, (_e1195 < _e1104));
let _e1202 = global_2.member[bitcast<u32>(select(0i, _e1197, (_e1197 > 0i)))];
let _e1203 = bitcast<f32>(_e1202);
let _e1204 = local_6.member[2u];
let _e1205 = (_e1193 + _e1204);
let _e1207 = select(_e1104, _e1205, (_e1205 < _e1104));
let _e1212 = global_2.member[bitcast<u32>(select(0i, _e1207, (_e1207 > 0i)))];
let _e1214 = local_7[0u];
let _e1217 = (_e1203 + ((bitcast<f32>(_e1212) - _e1203) * _e1214));
let _e1218 = (_e1128 + _e1125);
let _e1219 = local_6.member[1u];
let _e1220 = (_e1218 + _e1219);
let _e1222 = select(_e1104, _e1220, (_e1220 < _e1104));
let _e1227 = global_2.member[bitcast<u32>(select(0i, _e1222, (_e1222 > 0i)))];
let _e1228 = bitcast<f32>(_e1227);
let _e1229 = local_6.member[2u];
let _e1230 = (_e1218 + _e1229);
let _e1232 = select(_e1104, _e1230, (_e1230 < _e1104));
let _e1237 = global_2.member[bitcast<u32>(select(0i, _e1232, (_e1232 > 0i)))];
let _e1239 = local_7[0u];
let _e1244 = local_7[1u];
let _e1247 = (_e1167 + (((_e1178 + ((bitcast<f32>(_e1187) - _e1178) * _e1189)) - _e1167) * _e1244));
let _e1248 = local_7[1u];
let _e1253 = local_7[2u];
let _e1260 = global_1.member.member_6.member_5;
let _e1265 = global_1.member.member_6.member_6;
let _e1266 = (((_e1247 + (((_e1217 + (((_e1228 + ((bitcast<f32>(_e1237) - _e1228) * _e1239)) - _e1217) * _e1248)) - _e1247) * _e1253)) * _e1260) + _e1265);
let _e1268 = select(0f, _e1266, (_e1266 > 0f));
let _e1275 = global_1.member.member_7.member_3.member;
let _e1276 = (_e1275 - 0.5f);
let _e1278 = select(-0.5f, _e959, (_e959 > -0.5f));
let _e1280 = select(_e1276, _e1278, (_e1278 < _e1276));
let _e1285 = global_1.member.member_7.member_3.member_1;
let _e1286 = (_e1285 - 0.5f);
let _e1288 = select(-0.5f, _e974, (_e974 > -0.5f));
let _e1290 = select(_e1286, _e1288, (_e1288 < _e1286));
let _e1295 = global_1.member.member_7.member_3.member_2;
let _e1296 = (_e1295 - 0.5f);
let _e1298 = select(-0.5f, _e989, (_e989 > -0.5f));
let _e1300 = select(_e1296, _e1298, (_e1298 < _e1296));
let _e1302 = select(-1f, _e1280, (_e1280 > -1f));
let _e1304 = select(_e1275, _e1302, (_e1302 < _e1275));
let _e1311 = select(0i, select(select(i32(_e1304), i32(-2147483648), (_e1304 < -2147483600f)), 2147483647i, (_e1304 > 2147483500f)), (_e1304 == _e1304));
let _e1315 = (_e1311 - select(0i, 1i, (_e1304 < f32(_e1311))));
let _e1317 = select(-1f, _e1290, (_e1290 > -1f));
let _e1319 = select(_e1285, _e1317, (_e1317 < _e1285));
let _e1326 = select(0i, select(select(i32(_e1319), i32(-2147483648), (_e1319 < -2147483600f)), 2147483647i, (_e1319 > 2147483500f)), (_e1319 == _e1319));
let _e1330 = (_e1326 - select(0i, 1i, (_e1319 < f32(_e1326))));
let _e1332 = select(-1f, _e1300, (_e1300 > -1f));
let _e1334 = select(_e1295, _e1332, (_e1332 < _e1295));
let _e1341 = select(0i, select(select(i32(_e1334), i32(-2147483648), (_e1334 < -2147483600f)), 2147483647i, (_e1334 > 2147483500f)), (_e1334 == _e1334));
let _e1345 = (_e1341 - select(0i, 1i, (_e1334 < f32(_e1341))));
let _e1349 = global_1.member.member_7.member_7;
let _e1353 = global_1.member.member_7.member_8;
let _e1354 = (_e1315 + 1i);
let _e1355 = (_e1330 + 1i);
let _e1356 = (_e1345 + 1i);
let _e1361 = global_1.member.member_7.member_11.member;
let _e1367 = global_1.member.member_7.member_11.member_1;
let _e1378 = ((_e1354 >> bitcast<u32>(4i)) + (bitcast<i32>(_e1361) * ((_e1355 >> bitcast<u32>(4i)) + (bitcast<i32>(_e1367) * (_e1356 >> bitcast<u32>(4i))))));
let _e1380 = (bitcast<i32>(arrayLength((&global_7.member))) - 1i);
let _e1382 = select(_e1380, _e1378, (_e1378 < _e1380));
let _e1388 = global_7.member[bitcast<u32>(select(0i, _e1382, (_e1382 > 0i)))];
let _e1390 = (_e1354 & 15i);
let _e1393 = ((_e1355 & 15i) * _e1349);
let _e1395 = (bitcast<i32>(_e1388) + ((_e1356 & 15i) * _e1353));
let _e1399 = (_e1393 + _e1349);
let _e1401 = (_e1393 + (2i * _e1349));
let _e1403 = (_e1393 + (3i * _e1349));
let _e1404 = (_e1395 + _e1353);
let _e1406 = (_e1395 + (2i * _e1353));
let _e1408 = (_e1395 + (3i * _e1353));
local_4 = type_27(array<i32, 4>(_e1390, (_e1390 + 1i), (_e1390 + 2i), (_e1390 + 3i)), array<u32, 6>(0u, 16u, 0u, 16u, 0u, 16u));
local_5 = vec3<f32>((_e1280 - f32(_e1315)), (_e1290 - f32(_e1330)), (_e1300 - f32(_e1345)));
let _e1419 = (_e1404 + _e1399);
let _e1422 = local_4.member[0u];
let _e1423 = (_e1419 + _e1422);
let _e1425 = select(_e1380, _e1423, (_e1423 < _e1380));
let _e1430 = global_7.member[bitcast<u32>(select(0i, _e1425, (_e1425 > 0i)))];
let _e1431 = bitcast<f32>(_e1430);
let _e1434 = local_4.member[1u];
let _e1435 = (_e1419 + _e1434);
let _e1437 = select(_e1380, _e1435, (_e1435 < _e1380));
let _e1442 = global_7.member[bitcast<u32>(select(0i, _e1437, (_e1437 > 0i)))];
let _e1443 = bitcast<f32>(_e1442);
let _e1446 = local_4.member[2u];
let _e1447 = (_e1419 + _e1446);
let _e1449 = select(_e1380, _e1447, (_e1447 < _e1380));
let _e1454 = global_7.member[bitcast<u32>(select(0i, _e1449, (_e1449 > 0i)))];
let _e1455 = bitcast<f32>(_e1454);
let _e1458 = local_4.member[3u];
let _e1459 = (_e1419 + _e1458);
let _e1461 = select(_e1380, _e1459, (_e1459 < _e1380));
let _e1466 = global_7.member[bitcast<u32>(select(0i, _e1461, (_e1461 > 0i)))];
let _e1468 = local_5[0u];
let _e1471 = (_e1431 + ((_e1443 - _e1431) * _e1468));
let _e1472 = local_5[0u];
let _e1475 = (_e1443 + ((_e1455 - _e1443) * _e1472));
let _e1476 = local_5[0u];
let _e1479 = (_e1455 + ((bitcast<f32>(_e1466) - _e1455) * _e1476));
let _e1480 = (_e1404 + _e1401);
let _e1481 = local_4.member[0u];
let _e1482 = (_e1480 + _e1481);
let _e1484 = select(_e1380, _e1482, (_e1482 < _e1380));
let _e1489 = global_7.member[bitcast<u32>(select(0i, _e1484, (_e1484 > 0i)))];
let _e1490 = bitcast<f32>(_e1489);
let _e1491 = local_4.member[1u];
let _e1492 = (_e1480 + _e1491);
let _e1494 = select(_e1380, _e1492, (_e1492 < _e1380));
let _e1499 = global_7.member[bitcast<u32>(select(0i, _e1494, (_e1494 > 0i)))];
let _e1500 = bitcast<f32>(_e1499);
let _e1501 = local_4.member[2u];
let _e1502 = (_e1480 + _e1501);
let _e1504 = select(_e1380, _e1502, (_e1502 < _e1380));
let _e1509 = global_7.member[bitcast<u32>(select(0i, _e1504, (_e1504 > 0i)))];
let _e1510 = bitcast<f32>(_e1509);
let _e1511 = local_4.member[3u];
let _e1512 = (_e1480 + _e1511);
let _e1514 = select(_e1380, _e1512, (_e1512 < _e1380));
let _e1519 = global_7.member[bitcast<u32>(select(0i, _e1514, (_e1514 > 0i)))];
let _e1521 = local_5[0u];
let _e1525 = local_5[0u];
let _e1528 = (_e1500 + ((_e1510 - _e1500) * _e1525));
let _e1529 = local_5[0u];
let _e1533 = (_e1406 + _e1399);
let _e1534 = local_4.member[0u];
let _e1535 = (_e1533 + _e1534);
let _e1537 = select(_e1380, _e1535, (_e1535 < _e1380));
let _e1542 = global_7.member[bitcast<u32>(select(0i, _e1537, (_e1537 > 0i)))];
let _e1543 = bitcast<f32>(_e1542);
let _e1544 = local_4.member[1u];
let _e1545 = (_e1533 + _e1544);
let _e1547 = select(_e1380, _e1545, (_e1545 < _e1380));
let _e1552 = global_7.member[bitcast<u32>(select(0i, _e1547, (_e1547 > 0i)))];
let _e1553 = bitcast<f32>(_e1552);
let _e1554 = local_4.member[2u];
let _e1555 = (_e1533 + _e1554);
let _e1557 = select(_e1380, _e1555, (_e1555 < _e1380));
let _e1562 = global_7.member[bitcast<u32>(select(0i, _e1557, (_e1557 > 0i)))];
let _e1563 = bitcast<f32>(_e1562);
let _e1564 = local_4.member[3u];
let _e1565 = (_e1533 + _e1564);
let _e1567 = select(_e1380, _e1565, (_e1565 < _e1380));
let _e1572 = global_7.member[bitcast<u32>(select(0i, _e1567, (_e1567 > 0i)))];
let _e1574 = local_5[0u];
let _e1577 = (_e1543 + ((_e1553 - _e1543) * _e1574));
let _e1578 = local_5[0u];
let _e1581 = (_e1553 + ((_e1563 - _e1553) * _e1578));
let _e1582 = local_5[0u];
let _e1585 = (_e1563 + ((bitcast<f32>(_e1572) - _e1563) * _e1582));
let _e1586 = (_e1406 + _e1401);
let _e1587 = local_4.member[0u];
let _e1588 = (_e1586 + _e1587);
let _e1590 = select(_e1380, _e1588, (_e1588 < _e1380));
let _e1595 = global_7.member[bitcast<u32>(select(0i, _e1590, (_e1590 > 0i)))];
let _e1596 = bitcast<f32>(_e1595);
let _e1597 = local_4.member[1u];
let _e1598 = (_e1586 + _e1597);
let _e1600 = select(_e1380, _e1598, (_e1598 < _e1380));
let _e1605 = global_7.member[bitcast<u32>(select(0i, _e1600, (_e1600 > 0i)))];
let _e1606 = bitcast<f32>(_e1605);
let _e1607 = local_4.member[2u];
let _e1608 = (_e1586 + _e1607);
let _e1610 = select(_e1380, _e1608, (_e1608 < _e1380));
let _e1615 = global_7.member[bitcast<u32>(select(0i, _e1610, (_e1610 > 0i)))];
let _e1616 = bitcast<f32>(_e1615);
let _e1617 = local_4.member[3u];
let _e1618 = (_e1586 + _e1617);
let _e1620 = select(_e1380, _e1618, (_e1618 < _e1380));
let _e1625 = global_7.member[bitcast<u32>(select(0i, _e1620, (_e1620 > 0i)))];
let _e1627 = local_5[0u];
let _e1631 = local_5[0u];
let _e1634 = (_e1606 + ((_e1616 - _e1606) * _e1631));
let _e1635 = local_5[0u];
let _e1639 = (_e1404 + _e1393);
let _e1640 = local_4.member[1u];
let _e1641 = (_e1639 + _e1640);
let _e1643 = select(_e1380, _e1641, (_e1641 < _e1380));
let _e1648 = global_7.member[bitcast<u32>(select(0i, _e1643, (_e1643 > 0i)))];
let _e1649 = bitcast<f32>(_e1648);
let _e1650 = local_4.member[2u];
let _e1651 = (_e1639 + _e1650);
let _e1653 = select(_e1380, _e1651, (_e1651 < _e1380));
let _e1658 = global_7.member[bitcast<u32>(select(0i, _e1653, (_e1653 > 0i)))];
let _e1660 = local_5[0u];
let _e1663 = (_e1649 + ((bitcast<f32>(_e1658) - _e1649) * _e1660));
let _e1664 = (_e1404 + _e1403);
let _e1665 = local_4.member[1u];
let _e1666 = (_e1664 + _e1665);
let _e1668 = select(_e1380, _e1666, (_e1666 < _e1380));
let _e1673 = global_7.member[bitcast<u32>(select(0i, _e1668, (_e1668 > 0i)))];
let _e1674 = bitcast<f32>(_e1673);
let _e1675 = local_4.member[2u];
let _e1676 = (_e1664 + _e1675);
let _e1678 = select(_e1380, _e1676, (_e1676 < _e1380));
let _e1683 = global_7.member[bitcast<u32>(select(0i, _e1678, (_e1678 > 0i)))];
let _e1685 = local_5[0u];
let _e1689 = (_e1406 + _e1393);
let _e1690 = local_4.member[1u];
let _e1691 = (_e1689 + _e1690);
let _e1693 = select(_e1380, _e1691, (_e1691 < _e1380));
let _e1698 = global_7.member[bitcast<u32>(select(0i, _e1693, (_e1693 > 0i)))];
let _e1699 = bitcast<f32>(_e1698);
let _e1700 = local_4.member[2u];
let _e1701 = (_e1689 + _e1700);
let _e1703 = select(_e1380, _e1701, (_e1701 < _e1380));
let _e1708 = global_7.member[bitcast<u32>(select(0i, _e1703, (_e1703 > 0i)))];
let _e1710 = local_5[0u];
let _e1713 = (_e1699 + ((bitcast<f32>(_e1708) - _e1699) * _e1710));
let _e1714 = (_e1406 + _e1403);
let _e1715 = local_4.member[1u];
let _e1716 = (_e1714 + _e1715);
let _e1718 = select(_e1380, _e1716, (_e1716 < _e1380));
let _e1723 = global_7.member[bitcast<u32>(select(0i, _e1718, (_e1718 > 0i)))];
let _e1724 = bitcast<f32>(_e1723);
let _e1725 = local_4.member[2u];
let _e1726 = (_e1714 + _e1725);
let _e1728 = select(_e1380, _e1726, (_e1726 < _e1380));
let _e1733 = global_7.member[bitcast<u32>(select(0i, _e1728, (_e1728 > 0i)))];
let _e1735 = local_5[0u];
let _e1739 = (_e1395 + _e1399);
let _e1740 = local_4.member[1u];
let _e1741 = (_e1739 + _e1740);
let _e1743 = select(_e1380, _e1741, (_e1741 < _e1380));
let _e1748 = global_7.member[bitcast<u32>(select(0i, _e1743, (_e1743 > 0i)))];
let _e1749 = bitcast<f32>(_e1748);
let _e1750 = local_4.member[2u];
let _e1751 = (_e1739 + _e1750);
let _e1753 = select(_e1380, _e1751, (_e1751 < _e1380));
let _e1758 = global_7.member[bitcast<u32>(select(0i, _e1753, (_e1753 > 0i)))];
let _e1760 = local_5[0u];
let _e1763 = (_e1749 + ((bitcast<f32>(_e1758) - _e1749) * _e1760));
let _e1764 = (_e1408 + _e1399);
let _e1765 = local_4.member[1u];
let _e1766 = (_e1764 + _e1765);
let _e1768 = select(_e1380, _e1766, (_e1766 < _e1380));
let _e1773 = global_7.member[bitcast<u32>(select(0i, _e1768, (_e1768 > 0i)))];
let _e1774 = bitcast<f32>(_e1773);
let _e1775 = local_4.member[2u];
let _e1776 = (_e1764 + _e1775);
let _e1778 = select(_e1380, _e1776, (_e1776 < _e1380));
let _e1783 = global_7.member[bitcast<u32>(select(0i, _e1778, (_e1778 > 0i)))];
let _e1785 = local_5[0u];
let _e1788 = (_e1774 + ((bitcast<f32>(_e1783) - _e1774) * _e1785));
let _e1789 = (_e1395 + _e1401);
let _e1790 = local_4.member[1u];
let _e1791 = (_e1789 + _e1790);
let _e1793 = select(_e1380, _e1791, (_e1791 < _e1380));
let _e1798 = global_7.member[bitcast<u32>(select(0i, _e1793, (_e1793 > 0i)))];
let _e1799 = bitcast<f32>(_e1798);
let _e1800 = local_4.member[2u];
let _e1801 = (_e1789 + _e1800);
let _e1803 = select(_e1380, _e1801, (_e1801 < _e1380));
let _e1808 = global_7.member[bitcast<u32>(select(0i, _e1803, (_e1803 > 0i)))];
let _e1810 = local_5[0u];
let _e1814 = (_e1408 + _e1401);
let _e1815 = local_4.member[1u];
let _e1816 = (_e1814 + _e1815);
let _e1818 = select(_e1380, _e1816, (_e1816 < _e1380));
let _e1823 = global_7.member[bitcast<u32>(select(0i, _e1818, (_e1818 > 0i)))];
let _e1824 = bitcast<f32>(_e1823);
let _e1825 = local_4.member[2u];
let _e1826 = (_e1814 + _e1825);
let _e1828 = select(_e1380, _e1826, (_e1826 < _e1380));
let _e1833 = global_7.member[bitcast<u32>(select(0i, _e1828, (_e1828 > 0i)))];
let _e1835 = local_5[0u];
let _e1840 = local_5[1u];
let _e1843 = (_e1475 + ((_e1528 - _e1475) * _e1840));
let _e1844 = local_5[1u];
let _e1847 = (_e1581 + ((_e1634 - _e1581) * _e1844));
let _e1848 = local_5[1u];
let _e1851 = (_e1471 + (((_e1490 + ((_e1500 - _e1490) * _e1521)) - _e1471) * _e1848));
let _e1852 = local_5[1u];
let _e1857 = local_5[2u];
let _e1861 = local_5[1u];
let _e1864 = (_e1479 + (((_e1510 + ((bitcast<f32>(_e1519) - _e1510) * _e1529)) - _e1479) * _e1861));
let _e1865 = local_5[1u];
let _e1869 = local_5[2u];
let _e1873 = local_5[1u];
let _e1876 = (_e1663 + ((_e1475 - _e1663) * _e1873));
let _e1877 = local_5[1u];
let _e1881 = local_5[2u];
let _e1885 = local_5[1u];
let _e1888 = (_e1528 + (((_e1674 + ((bitcast<f32>(_e1683) - _e1674) * _e1685)) - _e1528) * _e1885));
let _e1889 = local_5[1u];
let _e1893 = local_5[2u];
let _e1897 = local_5[1u];
let _e1900 = (_e1763 + (((_e1799 + ((bitcast<f32>(_e1808) - _e1799) * _e1810)) - _e1763) * _e1897));
let _e1901 = local_5[2u];
let _e1905 = local_5[1u];
let _e1909 = local_5[2u];
let _e1913 = local_5[2u];
let _e1920 = global_1.member.member_7.member_5;
let _e1925 = global_1.member.member_7.member_6;
let _e1926 = (((_e1843 + ((_e1847 - _e1843) * _e1913)) * _e1920) + _e1925);
let _e1928 = select(0f, _e1926, (_e1926 > 0f));
let _e1932 = (((_e1851 + (((_e1577 + (((_e1596 + ((_e1606 - _e1596) * _e1627)) - _e1577) * _e1852)) - _e1851) * _e1857)) * _e1920) + _e1925);
let _e1934 = select(0f, _e1932, (_e1932 > 0f));
let _e1936 = select(1f, _e1934, (_e1934 < 1f));
let _e1938 = (((_e1864 + (((_e1585 + (((_e1616 + ((bitcast<f32>(_e1625) - _e1616) * _e1635)) - _e1585) * _e1865)) - _e1864) * _e1869)) * _e1920) + _e1925);
let _e1940 = select(0f, _e1938, (_e1938 > 0f));
let _e1942 = select(1f, _e1940, (_e1940 < 1f));
let _e1944 = (((_e1876 + (((_e1713 + ((_e1581 - _e1713) * _e1877)) - _e1876) * _e1881)) * _e1920) + _e1925);
let _e1946 = select(0f, _e1944, (_e1944 > 0f));
let _e1948 = select(1f, _e1946, (_e1946 < 1f));
let _e1950 = (((_e1888 + (((_e1634 + (((_e1724 + ((bitcast<f32>(_e1733) - _e1724) * _e1735)) - _e1634) * _e1889)) - _e1888) * _e1893)) * _e1920) + _e1925);
let _e1952 = select(0f, _e1950, (_e1950 > 0f));
let _e1954 = select(1f, _e1952, (_e1952 < 1f));
let _e1956 = (((_e1900 + ((_e1843 - _e1900) * _e1901)) * _e1920) + _e1925);
let _e1958 = select(0f, _e1956, (_e1956 > 0f));
let _e1960 = select(1f, _e1958, (_e1958 < 1f));
let _e1962 = (((_e1847 + (((_e1788 + (((_e1824 + ((bitcast<f32>(_e1833) - _e1824) * _e1835)) - _e1788) * _e1905)) - _e1847) * _e1909)) * _e1920) + _e1925);
let _e1964 = select(0f, _e1962, (_e1962 > 0f));
let _e1966 = select(1f, _e1964, (_e1964 < 1f));
let _e1967 = (select(1f, _e1928, (_e1928 < 1f)) * 1024f);
let _e1968 = (1024f - 1f);
let _e1970 = select(0f, _e1967, (_e1967 > 0f));
let _e1972 = select(_e1968, _e1970, (_e1970 < _e1968));
let _e1979 = select(0i, select(select(i32(_e1972), i32(-2147483648), (_e1972 < -2147483600f)), 2147483647i, (_e1972 > 2147483500f)), (_e1972 == _e1972));
let _e1983 = (_e1979 - select(0i, 1i, (_e1972 < f32(_e1979))));
let _e1984 = (262147i + _e1983);
let _e1986 = (bitcast<i32>(_e97) - 1i);
let _e1988 = select(_e1986, _e1984, (_e1984 < _e1986));
let _e1994 = global_4.member[bitcast<u32>(select(0i, _e1988, (_e1988 > 0i)))];
let _e2004 = select(_e1986, 262146i, (262146i < _e1986));
let _e2010 = global_4.member[bitcast<u32>(select(0i, _e2004, (_e2004 > 0i)))];
let _e2011 = bitcast<f32>(_e2010);
let _e2012 = (f32((bitcast<i32>((_e1994 & 4095u)) - 2048i)) * _e2011);
let _e2014 = select(_e1986, 262144i, (262144i < _e1986));
let _e2020 = global_4.member[bitcast<u32>(select(0i, _e2014, (_e2014 > 0i)))];
let _e2021 = bitcast<f32>(_e2020);
let _e2023 = select(_e1986, 262145i, (262145i < _e1986));
let _e2029 = global_4.member[bitcast<u32>(select(0i, _e2023, (_e2023 > 0i)))];
let _e2030 = bitcast<f32>(_e2029);
let _e2036 = ((_e2021 + (f32(bitcast<i32>((_e1994 >> bitcast<u32>(12u)))) * _e2030)) + (_e2012 * (_e1967 - f32(_e1983))));
let _e2037 = (_e2012 * 1024f);
if _e991 {
let _e2044 = ((0.5f * (_e1942 - _e1936)) * _e2037);
let _e2045 = ((0.5f * (_e1954 - _e1948)) * _e2037);
let _e2046 = ((0.5f * (_e1966 - _e1960)) * _e2037);
phi_4622_ = type_28(_e2036, vec3<f32>(_e2044, _e2045, _e2046), vec3<f32>((_e2044 * _e2036), (_e2045 * _e2036), (_e2046 * _e2036)));
} else {
let _e2053 = (_e1936 * 1024f);
let _e2055 = select(0f, _e2053, (_e2053 > 0f));
let _e2057 = select(_e1968, _e2055, (_e2055 < _e1968));
let _e2064 = select(0i, select(select(i32(_e2057), i32(-2147483648), (_e2057 < -2147483600f)), 2147483647i, (_e2057 > 2147483500f)), (_e2057 == _e2057));
let _e2068 = (_e2064 - select(0i, 1i, (_e2057 < f32(_e2064))));
let _e2069 = (262147i + _e2068);
let _e2071 = select(_e1986, _e2069, (_e2069 < _e1986));
let _e2077 = global_4.member[bitcast<u32>(select(0i, _e2071, (_e2071 > 0i)))];
let _e2092 = ((_e2021 + (f32(bitcast<i32>((_e2077 >> bitcast<u32>(12u)))) * _e2030)) + ((f32((bitcast<i32>((_e2077 & 4095u)) - 2048i)) * _e2011) * (_e2053 - f32(_e2068))));
let _e2093 = (_e1942 * 1024f);
let _e2095 = select(0f, _e2093, (_e2093 > 0f));
let _e2097 = select(_e1968, _e2095, (_e2095 < _e1968));
let _e2104 = select(0i, select(select(i32(_e2097), i32(-2147483648), (_e2097 < -2147483600f)), 2147483647i, (_e2097 > 2147483500f)), (_e2097 == _e2097));
let _e2108 = (_e2104 - select(0i, 1i, (_e2097 < f32(_e2104))));
let _e2109 = (262147i + _e2108);
let _e2111 = select(_e1986, _e2109, (_e2109 < _e1986));
let _e2117 = global_4.member[bitcast<u32>(select(0i, _e2111, (_e2111 > 0i)))];
let _e2132 = ((_e2021 + (f32(bitcast<i32>((_e2117 >> bitcast<u32>(12u)))) * _e2030)) + ((f32((bitcast<i32>((_e2117 & 4095u)) - 2048i)) * _e2011) * (_e2093 - f32(_e2108))));
let _e2133 = (_e1948 * 1024f);
let _e2135 = select(0f, _e2133, (_e2133 > 0f));
let _e2137 = select(_e1968, _e2135, (_e2135 < _e1968));
let _e2144 = select(0i, select(select(i32(_e2137), i32(-2147483648), (_e2137 < -2147483600f)), 2147483647i, (_e2137 > 2147483500f)), (_e2137 == _e2137));
let _e2148 = (_e2144 - select(0i, 1i, (_e2137 < f32(_e2144))));
let _e2149 = (262147i + _e2148);
let _e2151 = select(_e1986, _e2149, (_e2149 < _e1986));
let _e2157 = global_4.member[bitcast<u32>(select(0i, _e2151, (_e2151 > 0i)))];
let _e2172 = ((_e2021 + (f32(bitcast<i32>((_e2157 >> bitcast<u32>(12u)))) * _e2030)) + ((f32((bitcast<i32>((_e2157 & 4095u)) - 2048i)) * _e2011) * (_e2133 - f32(_e2148))));
let _e2173 = (_e1954 * 1024f);
let _e2175 = select(0f, _e2173, (_e2173 > 0f));
let _e2177 = select(_e1968, _e2175, (_e2175 < _e1968));
let _e2184 = select(0i, select(select(i32(_e2177), i32(-2147483648), (_e2177 < -2147483600f)), 2147483647i, (_e2177 > 2147483500f)), (_e2177 == _e2177));
let _e2188 = (_e2184 - select(0i, 1i, (_e2177 < f32(_e2184))));
let _e2189 = (262147i + _e2188);
let _e2191 = select(_e1986, _e2189, (_e2189 < _e1986));
let _e2197 = global_4.member[bitcast<u32>(select(0i, _e2191, (_e2191 > 0i)))];
let _e2212 = ((_e2021 + (f32(bitcast<i32>((_e2197 >> bitcast<u32>(12u)))) * _e2030)) + ((f32((bitcast<i32>((_e2197 & 4095u)) - 2048i)) * _e2011) * (_e2173 - f32(_e2188))));
let _e2213 = (_e1960 * 1024f);
let _e2215 = select(0f, _e2213, (_e2213 > 0f));
let _e2217 = select(_e1968, _e2215, (_e2215 < _e1968));
let _e2224 = select(0i, select(select(i32(_e2217), i32(-2147483648), (_e2217 < -2147483600f)), 2147483647i, (_e2217 > 2147483500f)), (_e2217 == _e2217));
let _e2228 = (_e2224 - select(0i, 1i, (_e2217 < f32(_e2224))));
let _e2229 = (262147i + _e2228);
let _e2231 = select(_e1986, _e2229, (_e2229 < _e1986));
let _e2237 = global_4.member[bitcast<u32>(select(0i, _e2231, (_e2231 > 0i)))];
let _e2252 = ((_e2021 + (f32(bitcast<i32>((_e2237 >> bitcast<u32>(12u)))) * _e2030)) + ((f32((bitcast<i32>((_e2237 & 4095u)) - 2048i)) * _e2011) * (_e2213 - f32(_e2228))));
let _e2253 = (_e1966 * 1024f);
let _e2255 = select(0f, _e2253, (_e2253 > 0f));
let _e2257 = select(_e1968, _e2255, (_e2255 < _e1968));
let _e2264 = select(0i, select(select(i32(_e2257), i32(-2147483648), (_e2257 < -2147483600f)), 2147483647i, (_e2257 > 2147483500f)), (_e2257 == _e2257));
let _e2268 = (_e2264 - select(0i, 1i, (_e2257 < f32(_e2264))));
let _e2269 = (262147i + _e2268);
let _e2271 = select(_e1986, _e2269, (_e2269 < _e1986));
let _e2277 = global_4.member[bitcast<u32>(select(0i, _e2271, (_e2271 > 0i)))];
let _e2292 = ((_e2021 + (f32(bitcast<i32>((_e2277 >> bitcast<u32>(12u)))) * _e2030)) + ((f32((bitcast<i32>((_e2277 & 4095u)) - 2048i)) * _e2011) * (_e2253 - f32(_e2268))));
let _e2293 = (_e2132 - _e2092);
let _e2295 = (_e2212 - _e2172);
let _e2297 = (_e2292 - _e2252);
phi_4622_ = type_28(_e2036, vec3<f32>((0.5f * _e2293), (0.5f * _e2295), (0.5f * _e2297)), vec3<f32>((0.25f * (_e2293 * (_e2132 + _e2092))), (0.25f * (_e2295 * (_e2212 + _e2172))), (0.25f * (_e2297 * (_e2292 + _e2252)))));
}
let _e2312 = phi_4622_;
let _e2327 = select(0f, 1f, ((((((_e959 >= -0.5f) && (_e959 <= _e1276)) && (_e974 >= -0.5f)) && (_e974 <= _e1286)) && (_e989 >= -0.5f)) && (_e989 <= _e1296)));
let _e2329 = (0.5f * (_e1942 - _e1936));
let _e2331 = (0.5f * (_e1954 - _e1948));
let _e2333 = (0.5f * (_e1966 - _e1960));
let _e2339 = global_1.member.member_7.member.member.member;
let _e2345 = global_1.member.member_7.member.member.member_1;
let _e2351 = global_1.member.member_7.member.member.member_2;
let _e2357 = global_1.member.member_7.member_1.member.member;
let _e2363 = global_1.member.member_7.member_1.member.member_1;
let _e2369 = global_1.member.member_7.member_1.member.member_2;
let _e2375 = global_1.member.member_7.member_2.member.member;
let _e2381 = global_1.member.member_7.member_2.member.member_1;
let _e2387 = global_1.member.member_7.member_2.member.member_2;
phi_5231_ = type_29(select(1f, _e1268, (_e1268 < 1f)), vec3<f32>(((((_e2339 * _e2329) + (_e2357 * _e2331)) + (_e2375 * _e2333)) * _e2327), ((((_e2345 * _e2329) + (_e2363 * _e2331)) + (_e2381 * _e2333)) * _e2327), ((((_e2351 * _e2329) + (_e2369 * _e2331)) + (_e2387 * _e2333)) * _e2327)), _e2312.member, vec3<f32>(((((_e2339 * _e2312.member_2.x) + (_e2357 * _e2312.member_2.y)) + (_e2375 * _e2312.member_2.z)) * _e2327), ((((_e2345 * _e2312.member_2.x) + (_e2363 * _e2312.member_2.y)) + (_e2381 * _e2312.member_2.z)) * _e2327), ((((_e2351 * _e2312.member_2.x) + (_e2369 * _e2312.member_2.y)) + (_e2387 * _e2312.member_2.z)) * _e2327)), vec3<f32>(((((_e2339 * _e2312.member_1.x) + (_e2357 * _e2312.member_1.y)) + (_e2375 * _e2312.member_1.z)) * _e2327), ((((_e2345 * _e2312.member_1.x) + (_e2363 * _e2312.member_1.y)) + (_e2381 * _e2312.member_1.z)) * _e2327), ((((_e2351 * _e2312.member_1.x) + (_e2369 * _e2312.member_1.y)) + (_e2387 * _e2312.member_1.z)) * _e2327)));
} else {
let _e2456 = global_1.member.member_6.member_3.member;
let _e2457 = (_e2456 - 0.5f);
let _e2459 = select(-0.5f, _e932, (_e932 > -0.5f));
let _e2461 = select(_e2457, _e2459, (_e2459 < _e2457));
let _e2466 = global_1.member.member_6.member_3.member_1;
let _e2467 = (_e2466 - 0.5f);
let _e2469 = select(-0.5f, _e938, (_e938 > -0.5f));
let _e2471 = select(_e2467, _e2469, (_e2469 < _e2467));
let _e2476 = global_1.member.member_6.member_3.member_2;
let _e2477 = (_e2476 - 0.5f);
let _e2479 = select(-0.5f, _e944, (_e944 > -0.5f));
let _e2481 = select(_e2477, _e2479, (_e2479 < _e2477));
let _e2483 = select(-1f, _e2461, (_e2461 > -1f));
let _e2485 = select(_e2456, _e2483, (_e2483 < _e2456));
let _e2492 = select(0i, select(select(i32(_e2485), i32(-2147483648), (_e2485 < -2147483600f)), 2147483647i, (_e2485 > 2147483500f)), (_e2485 == _e2485));
let _e2496 = (_e2492 - select(0i, 1i, (_e2485 < f32(_e2492))));
let _e2498 = select(-1f, _e2471, (_e2471 > -1f));
let _e2500 = select(_e2466, _e2498, (_e2498 < _e2466));
let _e2507 = select(0i, select(select(i32(_e2500), i32(-2147483648), (_e2500 < -2147483600f)), 2147483647i, (_e2500 > 2147483500f)), (_e2500 == _e2500));
let _e2511 = (_e2507 - select(0i, 1i, (_e2500 < f32(_e2507))));
let _e2513 = select(-1f, _e2481, (_e2481 > -1f));
let _e2515 = select(_e2476, _e2513, (_e2513 < _e2476));
let _e2522 = select(0i, select(select(i32(_e2515), i32(-2147483648), (_e2515 < -2147483600f)), 2147483647i, (_e2515 > 2147483500f)), (_e2515 == _e2515));
let _e2526 = (_e2522 - select(0i, 1i, (_e2515 < f32(_e2522))));
let _e2530 = global_1.member.member_6.member_7;
let _e2534 = global_1.member.member_6.member_8;
let _e2535 = (_e2496 + 1i);
let _e2536 = (_e2511 + 1i);
let _e2537 = (_e2526 + 1i);
let _e2542 = global_1.member.member_6.member_11.member;
let _e2548 = global_1.member.member_6.member_11.member_1;
let _e2559 = ((_e2535 >> bitcast<u32>(4i)) + (bitcast<i32>(_e2542) * ((_e2536 >> bitcast<u32>(4i)) + (bitcast<i32>(_e2548) * (_e2537 >> bitcast<u32>(4i))))));
let _e2561 = (bitcast<i32>(_e90) - 1i);
let _e2563 = select(_e2561, _e2559, (_e2559 < _e2561));
let _e2569 = global_2.member[bitcast<u32>(select(0i, _e2563, (_e2563 > 0i)))];
let _e2571 = (_e2535 & 15i);
let _e2574 = ((_e2536 & 15i) * _e2530);
let _e2576 = (bitcast<i32>(_e2569) + ((_e2537 & 15i) * _e2534));
let _e2580 = (_e2574 + _e2530);
let _e2582 = (_e2574 + (2i * _e2530));
let _e2583 = (_e2576 + _e2534);
let _e2585 = (_e2576 + (2i * _e2534));
local_2 = type_27(array<i32, 4>(_e2571, (_e2571 + 1i), (_e2571 + 2i), (_e2571 + 3i)), array<u32, 6>(0u, 16u, 0u, 16u, 0u, 16u));
local_3 = vec3<f32>((_e2461 - f32(_e2496)), (_e2471 - f32(_e2511)), (_e2481 - f32(_e2526)));
let _e2596 = (_e2583 + _e2580);
let _e2599 = local_2.member[1u];
let _e2600 = (_e2596 + _e2599);
let _e2602 = select(_e2561, _e2600, (_e2600 < _e2561));
let _e2607 = global_2.member[bitcast<u32>(select(0i, _e2602, (_e2602 > 0i)))];
let _e2608 = bitcast<f32>(_e2607);
let _e2611 = local_2.member[2u];
let _e2612 = (_e2596 + _e2611);
let _e2614 = select(_e2561, _e2612, (_e2612 < _e2561));
let _e2619 = global_2.member[bitcast<u32>(select(0i, _e2614, (_e2614 > 0i)))];
let _e2621 = local_3[0u];
let _e2624 = (_e2608 + ((bitcast<f32>(_e2619) - _e2608) * _e2621));
let _e2625 = (_e2583 + _e2582);
let _e2626 = local_2.member[1u];
let _e2627 = (_e2625 + _e2626);
let _e2629 = select(_e2561, _e2627, (_e2627 < _e2561));
let _e2634 = global_2.member[bitcast<u32>(select(0i, _e2629, (_e2629 > 0i)))];
let _e2635 = bitcast<f32>(_e2634);
let _e2636 = local_2.member[2u];
let _e2637 = (_e2625 + _e2636);
let _e2639 = select(_e2561, _e2637, (_e2637 < _e2561));
let _e2644 = global_2.member[bitcast<u32>(select(0i, _e2639, (_e2639 > 0i)))];
let _e2646 = local_3[0u];
let _e2651 = local_3[1u];
let _e2654 = (_e2624 + (((_e2635 + ((bitcast<f32>(_e2644) - _e2635) * _e2646)) - _e2624) * _e2651));
let _e2655 = (_e2585 + _e2580);
let _e2656 = local_2.member[1u];
let _e2657 = (_e2655 + _e2656);
let _e2659 = select(_e2561, _e2657, (_e2657 < _e2561));
let _e2664 = global_2.member[bitcast<u32>(select(0i, _e2659, (_e2659 > 0i)))];
let _e2665 = bitcast<f32>(_e2664);
let _e2666 = local_2.member[2u];
let _e2667 = (_e2655 + _e2666);
let _e2669 = select(_e2561, _e2667, (_e2667 < _e2561));
let _e2674 = global_2.member[bitcast<u32>(select(0i, _e2669, (_e2669 > 0i)))];
let _e2676 = local_3[0u];
let _e2679 = (_e2665 + ((bitcast<f32>(_e2674) - _e2665) * _e2676));
let _e2680 = (_e2585 + _e2582);
let _e2681 = local_2.member[1u];
let _e2682 = (_e2680 + _e2681);
let _e2684 = select(_e2561, _e2682, (_e2682 < _e2561));
let _e2689 = global_2.member[bitcast<u32>(select(0i, _e2684, (_e2684 > 0i)))];
let _e2690 = bitcast<f32>(_e2689);
let _e2691 = local_2.member[2u];
let _e2692 = (_e2680 + _e2691);
let _e2694 = select(_e2561, _e2692, (_e2692 < _e2561));
let _e2699 = global_2.member[bitcast<u32>(select(0i, _e2694, (_e2694 > 0i)))];
let _e2701 = local_3[0u];
let _e2705 = local_3[1u];
let _e2710 = local_3[2u];
let _e2717 = global_1.member.member_6.member_5;
let _e2722 = global_1.member.member_6.member_6;
let _e2723 = (((_e2654 + (((_e2679 + (((_e2690 + ((bitcast<f32>(_e2699) - _e2690) * _e2701)) - _e2679) * _e2705)) - _e2654) * _e2710)) * _e2717) + _e2722);
let _e2725 = select(0f, _e2723, (_e2723 > 0f));
phi_5231_ = type_29(select(1f, _e2725, (_e2725 < 1f)), vec3<f32>(0f, 0f, 0f), 1f, vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
}
let _e2730 = phi_5231_;
let _e2735 = global_1.member.member_6.member_3.member;
let _e2736 = (_e2735 - 0.5f);
let _e2738 = select(-0.5f, _e896, (_e896 > -0.5f));
let _e2740 = select(_e2736, _e2738, (_e2738 < _e2736));
let _e2745 = global_1.member.member_6.member_3.member_1;
let _e2746 = (_e2745 - 0.5f);
let _e2748 = select(-0.5f, _e911, (_e911 > -0.5f));
let _e2750 = select(_e2746, _e2748, (_e2748 < _e2746));
let _e2755 = global_1.member.member_6.member_3.member_2;
let _e2756 = (_e2755 - 0.5f);
let _e2758 = select(-0.5f, _e926, (_e926 > -0.5f));
let _e2760 = select(_e2756, _e2758, (_e2758 < _e2756));
let _e2762 = select(-1f, _e2740, (_e2740 > -1f));
let _e2764 = select(_e2735, _e2762, (_e2762 < _e2735));
let _e2771 = select(0i, select(select(i32(_e2764), i32(-2147483648), (_e2764 < -2147483600f)), 2147483647i, (_e2764 > 2147483500f)), (_e2764 == _e2764));
let _e2775 = (_e2771 - select(0i, 1i, (_e2764 < f32(_e2771))));
let _e2777 = select(-1f, _e2750, (_e2750 > -1f));
let _e2779 = select(_e2745, _e2777, (_e2777 < _e2745));
let _e2786 = select(0i, select(select(i32(_e2779), i32(-2147483648), (_e2779 < -2147483600f)), 2147483647i, (_e2779 > 2147483500f)), (_e2779 == _e2779));
let _e2790 = (_e2786 - select(0i, 1i, (_e2779 < f32(_e2786))));
let _e2792 = select(-1f, _e2760, (_e2760 > -1f));
let _e2794 = select(_e2755, _e2792, (_e2792 < _e2755));
let _e2801 = select(0i, select(select(i32(_e2794), i32(-2147483648), (_e2794 < -2147483600f)), 2147483647i, (_e2794 > 2147483500f)), (_e2794 == _e2794));
let _e2805 = (_e2801 - select(0i, 1i, (_e2794 < f32(_e2801))));
let _e2809 = global_1.member.member_6.member_7;
let _e2813 = global_1.member.member_6.member_8;
let _e2814 = (_e2775 + 1i);
let _e2815 = (_e2790 + 1i);
let _e2816 = (_e2805 + 1i);
let _e2821 = global_1.member.member_6.member_11.member;
let _e2827 = global_1.member.member_6.member_11.member_1;
let _e2838 = ((_e2814 >> bitcast<u32>(4i)) + (bitcast<i32>(_e2821) * ((_e2815 >> bitcast<u32>(4i)) + (bitcast<i32>(_e2827) * (_e2816 >> bitcast<u32>(4i))))));
let _e2840 = (bitcast<i32>(_e90) - 1i);
let _e2842 = select(_e2840, _e2838, (_e2838 < _e2840));
let _e2848 = global_2.member[bitcast<u32>(select(0i, _e2842, (_e2842 > 0i)))];
let _e2850 = (_e2814 & 15i);
let _e2853 = ((_e2815 & 15i) * _e2809);
let _e2855 = (bitcast<i32>(_e2848) + ((_e2816 & 15i) * _e2813));
let _e2859 = (_e2853 + _e2809);
let _e2861 = (_e2853 + (2i * _e2809));
let _e2862 = (_e2855 + _e2813);
let _e2864 = (_e2855 + (2i * _e2813));
local = type_27(array<i32, 4>(_e2850, (_e2850 + 1i), (_e2850 + 2i), (_e2850 + 3i)), array<u32, 6>(0u, 16u, 0u, 16u, 0u, 16u));
local_1 = vec3<f32>((_e2740 - f32(_e2775)), (_e2750 - f32(_e2790)), (_e2760 - f32(_e2805)));
let _e2875 = (_e2862 + _e2859);
let _e2878 = local.member[1u];
let _e2879 = (_e2875 + _e2878);
let _e2881 = select(_e2840, _e2879, (_e2879 < _e2840));
let _e2886 = global_2.member[bitcast<u32>(select(0i, _e2881, (_e2881 > 0i)))];
let _e2887 = bitcast<f32>(_e2886);
let _e2890 = local.member[2u];
let _e2891 = (_e2875 + _e2890);
let _e2893 = select(_e2840, _e2891, (_e2891 < _e2840));
let _e2898 = global_2.member[bitcast<u32>(select(0i, _e2893, (_e2893 > 0i)))];
let _e2900 = local_1[0u];
let _e2903 = (_e2887 + ((bitcast<f32>(_e2898) - _e2887) * _e2900));
let _e2904 = (_e2862 + _e2861);
let _e2905 = local.member[1u];
let _e2906 = (_e2904 + _e2905);
let _e2908 = select(_e2840, _e2906, (_e2906 < _e2840));
let _e2913 = global_2.member[bitcast<u32>(select(0i, _e2908, (_e2908 > 0i)))];
let _e2914 = bitcast<f32>(_e2913);
let _e2915 = local.member[2u];
let _e2916 = (_e2904 + _e2915);
let _e2918 = select(_e2840, _e2916, (_e2916 < _e2840));
let _e2923 = global_2.member[bitcast<u32>(select(0i, _e2918, (_e2918 > 0i)))];
let _e2925 = local_1[0u];
let _e2930 = local_1[1u];
let _e2933 = (_e2903 + (((_e2914 + ((bitcast<f32>(_e2923) - _e2914) * _e2925)) - _e2903) * _e2930));
let _e2934 = (_e2864 + _e2859);
let _e2935 = local.member[1u];
let _e2936 = (_e2934 + _e2935);
let _e2938 = select(_e2840, _e2936, (_e2936 < _e2840));
let _e2943 = global_2.member[bitcast<u32>(select(0i, _e2938, (_e2938 > 0i)))];
let _e2944 = bitcast<f32>(_e2943);
let _e2945 = local.member[2u];
let _e2946 = (_e2934 + _e2945);
let _e2948 = select(_e2840, _e2946, (_e2946 < _e2840));
let _e2953 = global_2.member[bitcast<u32>(select(0i, _e2948, (_e2948 > 0i)))];
let _e2955 = local_1[0u];
let _e2958 = (_e2944 + ((bitcast<f32>(_e2953) - _e2944) * _e2955));
let _e2959 = (_e2864 + _e2861);
let _e2960 = local.member[1u];
let _e2961 = (_e2959 + _e2960);
let _e2963 = select(_e2840, _e2961, (_e2961 < _e2840));
let _e2968 = global_2.member[bitcast<u32>(select(0i, _e2963, (_e2963 > 0i)))];
let _e2969 = bitcast<f32>(_e2968);
let _e2970 = local.member[2u];
let _e2971 = (_e2959 + _e2970);
let _e2973 = select(_e2840, _e2971, (_e2971 < _e2840));
let _e2978 = global_2.member[bitcast<u32>(select(0i, _e2973, (_e2973 > 0i)))];
let _e2980 = local_1[0u];
let _e2984 = local_1[1u];
let _e2989 = local_1[2u];
let _e2996 = global_1.member.member_6.member_5;
let _e3001 = global_1.member.member_6.member_6;
let _e3002 = (((_e2933 + (((_e2958 + (((_e2969 + ((bitcast<f32>(_e2978) - _e2969) * _e2980)) - _e2958) * _e2984)) - _e2933) * _e2989)) * _e2996) + _e3001);
let _e3004 = select(0f, _e3002, (_e3002 > 0f));
let _e3006 = select(1f, _e3004, (_e3004 < 1f));
let _e3009 = global_1.member.member_1;
if ((_e3009 & 16u) == 0u) {
phi_6027_ = type_5(1f, 1f, 1f);
} else {
let _e3015 = global_1.member.member_14.member;
let _e3026 = ((((_e3015.member.member * _e853) + (_e3015.member.member_1 * _e866)) + (_e3015.member.member_2 * _e831)) + _e3015.member_1);
let _e3032 = ((((_e3015.member.member * _e876) + (_e3015.member.member_1 * _e881)) + (_e3015.member.member_2 * _e870)) + _e3015.member_1);
let _e3034 = select(_e3032, _e3026, (_e3026 < _e3032));
let _e3036 = select(_e3032, _e3026, (_e3026 > _e3032));
let _e3038 = (_e3036 - _e3034);
let _e3041 = (-(_e3034) / select(1e-30f, _e3038, (_e3038 > 1e-30f)));
let _e3043 = select(0f, _e3041, (_e3041 > 0f));
let _e3049 = select(select(select(1f, _e3043, (_e3043 < 1f)), 1f, (_e3036 <= 0f)), 0f, (_e3034 > 0f));
let _e3054 = global_1.member.member_14.member_1;
let _e3055 = (_e3054 != 0u);
let _e3065 = global_1.member.member_15.member;
let _e3076 = ((((_e3065.member.member * _e853) + (_e3065.member.member_1 * _e866)) + (_e3065.member.member_2 * _e831)) + _e3065.member_1);
let _e3082 = ((((_e3065.member.member * _e876) + (_e3065.member.member_1 * _e881)) + (_e3065.member.member_2 * _e870)) + _e3065.member_1);
let _e3084 = select(_e3082, _e3076, (_e3076 < _e3082));
let _e3086 = select(_e3082, _e3076, (_e3076 > _e3082));
let _e3088 = (_e3086 - _e3084);
let _e3091 = (-(_e3084) / select(1e-30f, _e3088, (_e3088 > 1e-30f)));
let _e3093 = select(0f, _e3091, (_e3091 > 0f));
let _e3099 = select(select(select(1f, _e3093, (_e3093 < 1f)), 1f, (_e3086 <= 0f)), 0f, (_e3084 > 0f));
let _e3104 = global_1.member.member_15.member_1;
let _e3105 = (_e3104 != 0u);
let _e3115 = global_1.member.member_16.member;
let _e3126 = ((((_e3115.member.member * _e853) + (_e3115.member.member_1 * _e866)) + (_e3115.member.member_2 * _e831)) + _e3115.member_1);
let _e3132 = ((((_e3115.member.member * _e876) + (_e3115.member.member_1 * _e881)) + (_e3115.member.member_2 * _e870)) + _e3115.member_1);
let _e3134 = select(_e3132, _e3126, (_e3126 < _e3132));
let _e3136 = select(_e3132, _e3126, (_e3126 > _e3132));
let _e3138 = (_e3136 - _e3134);
let _e3141 = (-(_e3134) / select(1e-30f, _e3138, (_e3138 > 1e-30f)));
let _e3143 = select(0f, _e3141, (_e3141 > 0f));
let _e3149 = select(select(select(1f, _e3143, (_e3143 < 1f)), 1f, (_e3136 <= 0f)), 0f, (_e3134 > 0f));
let _e3154 = global_1.member.member_16.member_1;
let _e3155 = (_e3154 != 0u);
let _e3165 = global_1.member.member_17.member;
let _e3176 = ((((_e3165.member.member * _e853) + (_e3165.member.member_1 * _e866)) + (_e3165.member.member_2 * _e831)) + _e3165.member_1);
let _e3182 = ((((_e3165.member.member * _e876) + (_e3165.member.member_1 * _e881)) + (_e3165.member.member_2 * _e870)) + _e3165.member_1);
let _e3184 = select(_e3182, _e3176, (_e3176 < _e3182));
let _e3186 = select(_e3182, _e3176, (_e3176 > _e3182));
let _e3188 = (_e3186 - _e3184);
let _e3191 = (-(_e3184) / select(1e-30f, _e3188, (_e3188 > 1e-30f)));
let _e3193 = select(0f, _e3191, (_e3191 > 0f));
let _e3199 = select(select(select(1f, _e3193, (_e3193 < 1f)), 1f, (_e3186 <= 0f)), 0f, (_e3184 > 0f));
let _e3204 = global_1.member.member_17.member_1;
let _e3205 = (_e3204 != 0u);
phi_6027_ = type_5(((((1f * _e3049) * _e3099) * _e3149) * _e3199), ((((1f * select(1f, _e3049, _e3055)) * select(1f, _e3099, _e3105)) * select(1f, _e3149, _e3155)) * select(1f, _e3199, _e3205)), ((((1f * select(1f, 0f, (_e3055 && (_e3032 > 0f)))) * select(1f, 0f, (_e3105 && (_e3082 > 0f)))) * select(1f, 0f, (_e3155 && (_e3132 > 0f)))) * select(1f, 0f, (_e3205 && (_e3182 > 0f)))));
}
let _e3214 = phi_6027_;
let _e3215 = (_e932 - _e896);
let _e3219 = (bitcast<f32>((bitcast<u32>(_e3215) & 2147483647u)) < 1e-12f);
let _e3221 = (1f / select(_e3215, 1f, _e3219));
let _e3223 = ((-0.5f - _e896) * _e3221);
let _e3225 = ((_e2736 - _e896) * _e3221);
let _e3231 = select(_e3225, _e3223, (_e3223 < _e3225));
let _e3233 = select(0f, _e3231, (_e3231 > 0f));
let _e3236 = select(select(1f, _e3233, (_e3233 < 1f)), select(2f, 0f, ((_e896 >= -0.5f) && (_e896 <= _e2736))), _e3219);
let _e3238 = select(_e3225, _e3223, (_e3223 > _e3225));
let _e3240 = select(0f, _e3238, (_e3238 > 0f));
let _e3243 = select(select(1f, _e3240, (_e3240 < 1f)), 1f, _e3219);
let _e3244 = (_e938 - _e911);
let _e3248 = (bitcast<f32>((bitcast<u32>(_e3244) & 2147483647u)) < 1e-12f);
let _e3250 = (1f / select(_e3244, 1f, _e3248));
let _e3252 = ((-0.5f - _e911) * _e3250);
let _e3254 = ((_e2746 - _e911) * _e3250);
let _e3260 = select(_e3254, _e3252, (_e3252 < _e3254));
let _e3262 = select(0f, _e3260, (_e3260 > 0f));
let _e3265 = select(select(1f, _e3262, (_e3262 < 1f)), select(2f, 0f, ((_e911 >= -0.5f) && (_e911 <= _e2746))), _e3248);
let _e3267 = select(_e3254, _e3252, (_e3252 > _e3254));
let _e3269 = select(0f, _e3267, (_e3267 > 0f));
let _e3272 = select(select(1f, _e3269, (_e3269 < 1f)), 1f, _e3248);
let _e3273 = (_e944 - _e926);
let _e3277 = (bitcast<f32>((bitcast<u32>(_e3273) & 2147483647u)) < 1e-12f);
let _e3279 = (1f / select(_e3273, 1f, _e3277));
let _e3281 = ((-0.5f - _e926) * _e3279);
let _e3283 = ((_e2756 - _e926) * _e3279);
let _e3289 = select(_e3283, _e3281, (_e3281 < _e3283));
let _e3291 = select(0f, _e3289, (_e3289 > 0f));
let _e3294 = select(select(1f, _e3291, (_e3291 < 1f)), select(2f, 0f, ((_e926 >= -0.5f) && (_e926 <= _e2756))), _e3277);
let _e3296 = select(_e3283, _e3281, (_e3281 > _e3283));
let _e3298 = select(0f, _e3296, (_e3296 > 0f));
let _e3301 = select(select(1f, _e3298, (_e3298 < 1f)), 1f, _e3277);
let _e3303 = select(_e3272, _e3243, (_e3243 < _e3272));
let _e3307 = select(_e3265, _e3236, (_e3236 > _e3265));
let _e3310 = (select(_e3301, _e3303, (_e3303 < _e3301)) - select(_e3294, _e3307, (_e3307 > _e3294)));
let _e3313 = (_e876 - _e853);
let _e3314 = (_e881 - _e866);
let _e3315 = (_e870 - _e831);
let _e3320 = (((_e3313 * _e3313) + (_e3314 * _e3314)) + (_e3315 * _e3315));
let _e3328 = global_1.member.member_5.member_3;
let _e3329 = ((sqrt(select(0f, _e3320, (_e3320 > 0f))) * select(0f, _e3310, (_e3310 > 0f))) * _e3328);
if (_e107.member_2 >= 3u) {
let _e3332 = (_e3006 * 255f);
let _e3333 = (_e2730.member * 255f);
let _e3334 = (255f - 1f);
let _e3336 = select(0f, _e3332, (_e3332 > 0f));
let _e3338 = select(_e3334, _e3336, (_e3336 < _e3334));
let _e3345 = select(0i, select(select(i32(_e3338), i32(-2147483648), (_e3338 < -2147483600f)), 2147483647i, (_e3338 > 2147483500f)), (_e3338 == _e3338));
let _e3349 = (_e3345 - select(0i, 1i, (_e3338 < f32(_e3345))));
let _e3351 = select(0f, _e3333, (_e3333 > 0f));
let _e3353 = select(_e3334, _e3351, (_e3351 < _e3334));
let _e3360 = select(0i, select(select(i32(_e3353), i32(-2147483648), (_e3353 < -2147483600f)), 2147483647i, (_e3353 > 2147483500f)), (_e3353 == _e3353));
let _e3364 = (_e3360 - select(0i, 1i, (_e3353 < f32(_e3360))));
let _e3367 = (((_e3349 * 256i) + _e3364) * 4i);
let _e3371 = (_e3333 - f32(_e3364));
let _e3373 = (bitcast<i32>(_e97) - 1i);
let _e3375 = select(_e3373, _e3367, (_e3367 < _e3373));
let _e3381 = global_4.member[bitcast<u32>(select(0i, _e3375, (_e3375 > 0i)))];
let _e3382 = (_e3367 + 4i);
let _e3384 = select(_e3373, _e3382, (_e3382 < _e3373));
let _e3390 = global_4.member[bitcast<u32>(select(0i, _e3384, (_e3384 > 0i)))];
let _e3391 = (_e3367 + 1024i);
let _e3393 = select(_e3373, _e3391, (_e3391 < _e3373));
let _e3399 = global_4.member[bitcast<u32>(select(0i, _e3393, (_e3393 > 0i)))];
let _e3400 = (_e3367 + 1028i);
let _e3402 = select(_e3373, _e3400, (_e3400 < _e3373));
let _e3408 = global_4.member[bitcast<u32>(select(0i, _e3402, (_e3402 > 0i)))];
let _e3413 = (bitcast<f32>(((_e3381 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3421 = (_e3413 + (((bitcast<f32>(((_e3390 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3413) * _e3371));
let _e3426 = (bitcast<f32>(((_e3399 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3437 = (_e3421 + (((_e3426 + (((bitcast<f32>(((_e3408 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3426) * _e3371)) - _e3421) * (_e3332 - f32(_e3349))));
let _e3441 = -((_e3437 * (_e3329 * _e3214.member)));
let _e3443 = select(-87f, _e3441, (_e3441 > -87f));
let _e3445 = select(88f, _e3443, (_e3443 < 88f));
let _e3447 = ((_e3445 * 1.442695f) + 0.5f);
let _e3449 = select(-127f, _e3447, (_e3447 > -127f));
let _e3451 = select(128f, _e3449, (_e3449 < 128f));
let _e3458 = select(0i, select(select(i32(_e3451), i32(-2147483648), (_e3451 < -2147483600f)), 2147483647i, (_e3451 > 2147483500f)), (_e3451 == _e3451));
let _e3462 = (_e3458 - select(0i, 1i, (_e3451 < f32(_e3458))));
let _e3463 = f32(_e3462);
let _e3467 = ((_e3445 - (_e3463 * 0.6933594f)) - (_e3463 * -2.1219444e-4f));
let _e3487 = ((1f + (_e3467 * (1f + (_e3467 * (0.5f + (_e3467 * (0.16666667f + (_e3467 * (0.041666668f + (_e3467 * (0.008333334f + (_e3467 * (0.001388889f + (_e3467 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3462 + 127i)) << bitcast<u32>(23i))));
let _e3488 = (1f - _e3487);
phi_7137_ = type_30(_e3487, _e3488, vec3<f32>(1f, 1f, 1f), vec3((0f * (_e3488 / select(1e-12f, _e3437, (_e3437 > 1e-12f))))));
} else {
let _e3496 = (_e3006 * 255f);
let _e3497 = (_e2730.member * 255f);
let _e3498 = (255f - 1f);
let _e3500 = select(0f, _e3496, (_e3496 > 0f));
let _e3502 = select(_e3498, _e3500, (_e3500 < _e3498));
let _e3509 = select(0i, select(select(i32(_e3502), i32(-2147483648), (_e3502 < -2147483600f)), 2147483647i, (_e3502 > 2147483500f)), (_e3502 == _e3502));
let _e3513 = (_e3509 - select(0i, 1i, (_e3502 < f32(_e3509))));
let _e3515 = select(0f, _e3497, (_e3497 > 0f));
let _e3517 = select(_e3498, _e3515, (_e3515 < _e3498));
let _e3524 = select(0i, select(select(i32(_e3517), i32(-2147483648), (_e3517 < -2147483600f)), 2147483647i, (_e3517 > 2147483500f)), (_e3517 == _e3517));
let _e3528 = (_e3524 - select(0i, 1i, (_e3517 < f32(_e3524))));
let _e3531 = (((_e3513 * 256i) + _e3528) * 4i);
let _e3533 = (_e3496 - f32(_e3513));
let _e3535 = (_e3497 - f32(_e3528));
let _e3537 = (bitcast<i32>(_e97) - 1i);
let _e3539 = select(_e3537, _e3531, (_e3531 < _e3537));
let _e3545 = global_4.member[bitcast<u32>(select(0i, _e3539, (_e3539 > 0i)))];
let _e3546 = (_e3531 + 4i);
let _e3548 = select(_e3537, _e3546, (_e3546 < _e3537));
let _e3554 = global_4.member[bitcast<u32>(select(0i, _e3548, (_e3548 > 0i)))];
let _e3555 = (_e3531 + 1024i);
let _e3557 = select(_e3537, _e3555, (_e3555 < _e3537));
let _e3563 = global_4.member[bitcast<u32>(select(0i, _e3557, (_e3557 > 0i)))];
let _e3564 = (_e3531 + 1028i);
let _e3566 = select(_e3537, _e3564, (_e3564 < _e3537));
let _e3572 = global_4.member[bitcast<u32>(select(0i, _e3566, (_e3566 > 0i)))];
let _e3577 = (bitcast<f32>(((_e3545 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3585 = (_e3577 + (((bitcast<f32>(((_e3554 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3577) * _e3535));
let _e3590 = (bitcast<f32>(((_e3563 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3601 = (_e3585 + (((_e3590 + (((bitcast<f32>(((_e3572 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3590) * _e3535)) - _e3585) * _e3533));
let _e3614 = (bitcast<f32>((((_e3545 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3622 = (_e3614 + (((bitcast<f32>((((_e3554 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3614) * _e3535));
let _e3627 = (bitcast<f32>((((_e3563 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3639 = (_e3531 + 1i);
let _e3641 = select(_e3537, _e3639, (_e3639 < _e3537));
let _e3647 = global_4.member[bitcast<u32>(select(0i, _e3641, (_e3641 > 0i)))];
let _e3648 = (_e3531 + 5i);
let _e3650 = select(_e3537, _e3648, (_e3648 < _e3537));
let _e3656 = global_4.member[bitcast<u32>(select(0i, _e3650, (_e3650 > 0i)))];
let _e3657 = (_e3531 + 1025i);
let _e3659 = select(_e3537, _e3657, (_e3657 < _e3537));
let _e3665 = global_4.member[bitcast<u32>(select(0i, _e3659, (_e3659 > 0i)))];
let _e3666 = (_e3531 + 1029i);
let _e3668 = select(_e3537, _e3666, (_e3666 < _e3537));
let _e3674 = global_4.member[bitcast<u32>(select(0i, _e3668, (_e3668 > 0i)))];
let _e3679 = (bitcast<f32>(((_e3647 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3687 = (_e3679 + (((bitcast<f32>(((_e3656 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3679) * _e3535));
let _e3692 = (bitcast<f32>(((_e3665 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3716 = (bitcast<f32>((((_e3647 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3724 = (_e3716 + (((bitcast<f32>((((_e3656 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3716) * _e3535));
let _e3729 = (bitcast<f32>((((_e3665 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f);
let _e3744 = (_e3329 * _e3214.member_1);
let _e3746 = -(((_e3622 + (((_e3627 + (((bitcast<f32>((((_e3572 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3627) * _e3535)) - _e3622) * _e3533)) * _e3744));
let _e3748 = select(-87f, _e3746, (_e3746 > -87f));
let _e3750 = select(88f, _e3748, (_e3748 < 88f));
let _e3752 = ((_e3750 * 1.442695f) + 0.5f);
let _e3754 = select(-127f, _e3752, (_e3752 > -127f));
let _e3756 = select(128f, _e3754, (_e3754 < 128f));
let _e3763 = select(0i, select(select(i32(_e3756), i32(-2147483648), (_e3756 < -2147483600f)), 2147483647i, (_e3756 > 2147483500f)), (_e3756 == _e3756));
let _e3767 = (_e3763 - select(0i, 1i, (_e3756 < f32(_e3763))));
let _e3768 = f32(_e3767);
let _e3772 = ((_e3750 - (_e3768 * 0.6933594f)) - (_e3768 * -2.1219444e-4f));
let _e3794 = -(((_e3687 + (((_e3692 + (((bitcast<f32>(((_e3674 & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3692) * _e3535)) - _e3687) * _e3533)) * _e3744));
let _e3796 = select(-87f, _e3794, (_e3794 > -87f));
let _e3798 = select(88f, _e3796, (_e3796 < 88f));
let _e3800 = ((_e3798 * 1.442695f) + 0.5f);
let _e3802 = select(-127f, _e3800, (_e3800 > -127f));
let _e3804 = select(128f, _e3802, (_e3802 < 128f));
let _e3811 = select(0i, select(select(i32(_e3804), i32(-2147483648), (_e3804 < -2147483600f)), 2147483647i, (_e3804 > 2147483500f)), (_e3804 == _e3804));
let _e3815 = (_e3811 - select(0i, 1i, (_e3804 < f32(_e3811))));
let _e3816 = f32(_e3815);
let _e3820 = ((_e3798 - (_e3816 * 0.6933594f)) - (_e3816 * -2.1219444e-4f));
let _e3842 = -(((_e3724 + (((_e3729 + (((bitcast<f32>((((_e3674 >> bitcast<u32>(16i)) & 32767u) << bitcast<u32>(13i))) * 5.0706024e30f) - _e3729) * _e3535)) - _e3724) * _e3533)) * _e3744));
let _e3844 = select(-87f, _e3842, (_e3842 > -87f));
let _e3846 = select(88f, _e3844, (_e3844 < 88f));
let _e3848 = ((_e3846 * 1.442695f) + 0.5f);
let _e3850 = select(-127f, _e3848, (_e3848 > -127f));
let _e3852 = select(128f, _e3850, (_e3850 < 128f));
let _e3859 = select(0i, select(select(i32(_e3852), i32(-2147483648), (_e3852 < -2147483600f)), 2147483647i, (_e3852 > 2147483500f)), (_e3852 == _e3852));
let _e3863 = (_e3859 - select(0i, 1i, (_e3852 < f32(_e3859))));
let _e3864 = f32(_e3863);
let _e3868 = ((_e3846 - (_e3864 * 0.6933594f)) - (_e3864 * -2.1219444e-4f));
let _e3891 = -((_e3601 * (_e3329 * _e3214.member)));
let _e3893 = select(-87f, _e3891, (_e3891 > -87f));
let _e3895 = select(88f, _e3893, (_e3893 < 88f));
let _e3897 = ((_e3895 * 1.442695f) + 0.5f);
let _e3899 = select(-127f, _e3897, (_e3897 > -127f));
let _e3901 = select(128f, _e3899, (_e3899 < 128f));
let _e3908 = select(0i, select(select(i32(_e3901), i32(-2147483648), (_e3901 < -2147483600f)), 2147483647i, (_e3901 > 2147483500f)), (_e3901 == _e3901));
let _e3912 = (_e3908 - select(0i, 1i, (_e3901 < f32(_e3908))));
let _e3913 = f32(_e3912);
let _e3917 = ((_e3895 - (_e3913 * 0.6933594f)) - (_e3913 * -2.1219444e-4f));
let _e3937 = ((1f + (_e3917 * (1f + (_e3917 * (0.5f + (_e3917 * (0.16666667f + (_e3917 * (0.041666668f + (_e3917 * (0.008333334f + (_e3917 * (0.001388889f + (_e3917 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3912 + 127i)) << bitcast<u32>(23i))));
let _e3938 = (1f - _e3937);
phi_7137_ = type_30(_e3937, _e3938, vec3<f32>(((1f + (_e3772 * (1f + (_e3772 * (0.5f + (_e3772 * (0.16666667f + (_e3772 * (0.041666668f + (_e3772 * (0.008333334f + (_e3772 * (0.001388889f + (_e3772 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3767 + 127i)) << bitcast<u32>(23i)))), ((1f + (_e3820 * (1f + (_e3820 * (0.5f + (_e3820 * (0.16666667f + (_e3820 * (0.041666668f + (_e3820 * (0.008333334f + (_e3820 * (0.001388889f + (_e3820 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3815 + 127i)) << bitcast<u32>(23i)))), ((1f + (_e3868 * (1f + (_e3868 * (0.5f + (_e3868 * (0.16666667f + (_e3868 * (0.041666668f + (_e3868 * (0.008333334f + (_e3868 * (0.001388889f + (_e3868 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e3863 + 127i)) << bitcast<u32>(23i))))), vec3((0f * (_e3938 / select(1e-12f, _e3601, (_e3601 > 1e-12f))))));
}
let _e3946 = phi_7137_;
if _e994 {
let _e3950 = global_1.member.member_5.member_2;
let _e3958 = global_1.member.member_5.member_4;
let _e3961 = (_e2730.member_3.x * _e3214.member_2);
let _e3963 = (_e2730.member_3.y * _e3214.member_2);
let _e3965 = (_e2730.member_3.z * _e3214.member_2);
let _e3966 = (0.5f * (_e3950 / select(1e-6f, _e187, (_e187 > 1e-6f))));
let _e3970 = (_e165 + (_e3961 * _e3966));
let _e3971 = (_e176 + (_e3963 * _e3966));
let _e3972 = (_e187 + (_e3965 * _e3966));
let _e3974 = (2f * _e3950);
let _e3976 = ((_e3972 * _e3972) + (_e3974 * _e3965));
let _e3980 = (_e3972 + sqrt(select(0f, _e3976, (_e3976 > 0f))));
let _e3984 = (0.5f * (_e3974 / select(1e-6f, _e3980, (_e3980 > 1e-6f))));
let _e3988 = (_e3970 + (_e3961 * _e3984));
let _e3989 = (_e3971 + (_e3963 * _e3984));
let _e3990 = (_e3972 + (_e3965 * _e3984));
let _e3994 = (_e3958 * _e3958);
let _e3996 = (_e3990 * _e3990);
let _e4004 = (((_e3972 <= 0f) || (_e3976 <= 0f)) || ((_e3990 <= 0f) || (_e3996 <= (_e3994 * (((_e3988 * _e3988) + (_e3989 * _e3989)) + _e3996)))));
let _e4018 = (_e165 + ((_e2730.member_4.x * _e3214.member_2) * _e3950));
let _e4019 = (_e176 + ((_e2730.member_4.y * _e3214.member_2) * _e3950));
let _e4020 = (_e187 + ((_e2730.member_4.z * _e3214.member_2) * _e3950));
let _e4022 = (_e4020 * _e4020);
let _e4031 = ((_e3009 & 1u) != 0u);
let _e4035 = select(_e4004, ((_e4020 <= 0f) || (_e4022 <= (_e3994 * (((_e4018 * _e4018) + (_e4019 * _e4019)) + _e4022)))), _e4031);
phi_7288_ = select(select(select(_e3990, _e3972, _e4004), _e4020, _e4031), _e187, _e4035);
phi_7289_ = select(select(select(_e3989, _e3971, _e4004), _e4019, _e4031), _e176, _e4035);
phi_7290_ = select(select(select(_e3988, _e3970, _e4004), _e4018, _e4031), _e165, _e4035);
phi_7291_ = select(1f, 0f, _e4035);
} else {
phi_7288_ = _e187;
phi_7289_ = _e176;
phi_7290_ = _e165;
phi_7291_ = 1f;
}
let _e4041 = phi_7288_;
let _e4043 = phi_7289_;
let _e4045 = phi_7290_;
let _e4047 = phi_7291_;
let _e4050 = (_e3946.member * _e4047);
global_5.member[_e122] = (_e133 * (_e3946.member_2.x * _e4050));
global_5.member[_e134] = (_e143 * (_e3946.member_2.y * _e4050));
global_5.member[_e145] = (_e154 * (_e3946.member_2.z * _e4050));
global_5.member[_e156] = _e4045;
global_5.member[_e167] = _e4043;
global_5.member[_e178] = _e4041;
global_5.member[_e189] = _e198;
global_5.member[_e200] = _e209;
global_5.member[_e211] = _e220;
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
